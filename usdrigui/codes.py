"""The catalogue of issue codes: how severe each is, what it means, how to repair its cause.

A code is never reused or renamed.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from enum import IntEnum
from types import MappingProxyType
from typing import Literal

Severity = Literal["info", "warning", "error"]


class Exit(IntEnum):
    """Process exit codes of every command."""

    OK = 0
    """Written or unchanged; warnings allowed."""
    REFUSED = 1
    """The asset was refused, or `--strict` met a warning."""
    USAGE = 2
    """Wrong command line or configuration."""
    FILE = 3
    """A file could not be read or written."""
    LIMIT = 4
    """A time or memory limit was hit before there was a usable result."""
    BUG = 5
    """A bug of usdrigui."""


@dataclass(frozen=True, slots=True)
class Code:
    """Catalogue entry of one issue code."""

    severity: Severity
    meaning: str
    """One sentence, without the facts of the case."""
    repair: str
    """What the user can do about it."""
    exit: Exit = Exit.REFUSED
    """Exit code when the issue ends the run."""


_CODES: dict[str, Code] = {
    # --- files -----------------------------------------------------------------------------------
    "FILE_NOT_FOUND": Code(
        "error",
        "The file does not exist or cannot be read.",
        "Check the path and the permissions.",
        Exit.FILE,
    ),
    "FILE_NOT_USD": Code(
        "error",
        "USD cannot read the file as a layer.",
        "Mend the line that the message names in a layer written by hand; export any other file"
        " again as .usd, .usda, .usdc or .usdz.",
    ),
    # --- the process that reads the asset --------------------------------------------------------
    "SOURCE_NOT_A_FILE": Code(
        "error", "The asset is not a regular file.", "Name the asset's root layer.", Exit.FILE
    ),
    "SOURCE_IS_LAYOUT": Code(
        "error",
        "The file is a layout layer, not a character.",
        "Process the character that it sublayers; --previous keeps the places of this layer.",
    ),
    "SOURCE_HAS_LAYOUT": Code(
        "error",
        "The asset already composes a layout of the character; a second one over it would mix"
        " with it.",
        "To make that layout again, run `usdrigui process CHAR --bare -o` with the file named; to"
        " keep it and add what it lacks, give that file as --base; to remove it, run `usdrigui"
        " detach` first.",
    ),
    "SOURCE_LFS_POINTER": Code(
        "error",
        "The file is a Git LFS pointer: the asset itself was never fetched.",
        "Run `git lfs pull` in its repository.",
        Exit.FILE,
    ),
    "SOURCE_TOO_LARGE": Code(
        "error", "The file is larger than the limit.", "Raise `read.size_limit` (MiB).", Exit.LIMIT
    ),
    "SOURCE_CRASHES_USD": Code(
        "error",
        "USD crashed while it read the asset.",
        "Export the asset again; if usdchecker passes on the file, please file an OpenUSD issue.",
    ),
    "SOURCE_TIME_LIMIT": Code(
        "error",
        "Reading the asset took longer than the limit.",
        "Raise `read.time_limit` (seconds), or export the asset as .usdc.",
        Exit.LIMIT,
    ),
    "SOURCE_MEMORY_LIMIT": Code(
        "error",
        "Reading the asset took more memory than the limit.",
        "Raise `read.memory_limit` (MiB), or export the asset as .usdc.",
        Exit.LIMIT,
    ),
    "SOURCE_READER_LOST": Code(
        "error",
        "The process that reads the asset could not be started, or was ended from outside.",
        "Look for a memory limit of the machine or the farm, and run again.",
        Exit.LIMIT,
    ),
    "SOURCE_CHANGED": Code(
        "error",
        "A file of the asset changed while usdrigui was at work; nothing was written.",
        "Run again when the asset is complete.",
        Exit.FILE,
    ),
    # --- reading the asset -----------------------------------------------------------------------
    "FILE_NAME": Code("error", "No layer could refer to a file of this name.", "Rename the file."),
    "USD_ERROR": Code(
        "error",
        "USD failed while the asset was read.",
        "Check the asset with `usdchecker`, or export it again.",
    ),
    "ARRAY_TYPE": Code(
        "error", "An attribute holds values of another type.", "Author it with its schema's type."
    ),
    "FILE_CORRUPT": Code("error", "The archive is damaged.", "Copy or export the asset again."),
    "LAYER_MISSING": Code(
        "error",
        "The asset refers to a layer that cannot be found.",
        "Restore the file, correct the asset path, or set the resolver's search path.",
    ),
    "LAYER_UNREADABLE": Code(
        "error",
        "The asset refers to a layer that exists but that USD cannot read: damaged, of an"
        " obsolete or later crate version, or of a format without a plug-in.",
        "Export that layer again with a current USD, restore an undamaged copy, or install its"
        " file-format plug-in; the message holds USD's own error.",
    ),
    "COMPOSITION_ERROR": Code(
        "warning",
        "USD could not compose a part of the stage.",
        "Correct the composition arc at the prim named.",
    ),
    "USD_DIAGNOSTIC": Code(
        "info",
        "USD gave a warning while the asset was read.",
        "See the message; another issue often names the cause.",
    ),
    "SKELROOT_MISSING": Code(
        "error",
        "The stage has no SkelRoot.",
        "Put the character's meshes and Skeleton under a SkelRoot prim, or select the variant that"
        " has one.",
    ),
    "SKELROOT_UNKNOWN": Code(
        "error",
        "The prim that `read.skel_root` names is not a SkelRoot of the stage.",
        "Name one of the SkelRoots listed, or leave the setting out.",
        Exit.USAGE,
    ),
    "CONTROLS_MISSING": Code(
        "error",
        "No SkelRoot has a blend shape, joint or pose to control.",
        "Repair the prim that the message names; else add blend shapes or an animated skeleton,"
        " bind a Skeleton (skel:skeleton) to meshes that have blend shapes but none, make joints"
        " controls (`--set read.joints=all`, or `[joints.NAME]` in a configuration), or name poses"
        " in the configuration.",
    ),
    "INSTANCE": Code(
        "error",
        "The character is inside an instance, where no layer can add or edit prims.",
        "Set `instanceable = false` on the prim named, process the referenced asset itself, or lay"
        " out a character that is in no instance alone (`--set read.skel_root=PATH`).",
    ),
    "VARIANT_UNKNOWN": Code(
        "error",
        "No prim of the stage has the variant set, or the variant, to select.",
        "Select one that the message names.",
        Exit.USAGE,
    ),
    "VARIANT_BELOW": Code(
        "error",
        "A layout cannot be authored in the variant: its set is not on a SkelRoot or a prim above"
        " one.",
        "Move the variant set to the SkelRoot or above, or lay the character out without naming"
        " this set.",
    ),
    "VARIANT_LEFT_OFF": Code(
        "info",
        "A variant has no character to lay out, or no layout to check or compare.",
        "Nothing, if that is intended, as for a level of detail without blend shapes.",
    ),
    "TARGETS_LENGTH": Code(
        "error",
        "skel:blendShapes and skel:blendShapeTargets differ in length.",
        "Author one target for each blend-shape name, in the same order.",
    ),
    "TARGET_INVALID": Code(
        "warning",
        "A blend-shape target is not a BlendShape prim; the shape is ignored, as UsdSkel does.",
        "Correct the target or remove the name.",
    ),
    "OFFSETS_LENGTH": Code(
        "error",
        "A blend shape's offsets do not match its pointIndices or the mesh's points.",
        "Author one offset per point index, or per point when there are no indices.",
    ),
    "INDEX_RANGE": Code(
        "error", "An index is out of range.", "Correct the array named, or export the asset again."
    ),
    "NOT_FINITE": Code(
        "error", "An array holds NaN or infinity.", "Correct the values, or export the asset again."
    ),
    "INFLUENCES_LENGTH": Code(
        "error",
        "The joint influences do not match each other or the mesh's points.",
        "Author jointIndices and jointWeights of equal size: points times elementSize, or"
        " elementSize if constant.",
    ),
    "JOINT_UNKNOWN": Code(
        "error",
        "A mesh names a joint that its Skeleton does not have.",
        "Correct skel:joints of the prim named.",
    ),
    "SKELETON_INVALID": Code(
        "error",
        "The Skeleton's joints, bind transforms or rest transforms are unusable, or its world"
        " transform cannot be inverted.",
        "Author one valid bind and rest transform per joint, parents before children; where the"
        " message names the transform of a prim, author one without a scale of 0.",
    ),
    "ANIMATION_LENGTH": Code(
        "error",
        "A SkelAnimation's values do not match its names in number.",
        "Author one value per blend shape or joint at every time.",
    ),
    "TOPOLOGY_INVALID": Code(
        "error",
        "The face counts and face indices of a mesh contradict each other.",
        "Correct the mesh, or export the asset again.",
    ),
    "PART_LEFT_OFF": Code(
        "warning",
        "An invalid mesh, blend shape or GeomSubset is left off; the rest of the character is laid"
        " out without it.",
        "Repair the prim that the message names, by the code in the message.",
    ),
    "MESH_UNBOUND": Code(
        "warning",
        "A mesh has blend shapes or joint influences but no Skeleton is bound to it, so that"
        " USD does not deform it.",
        "Repair the binding that the message names; if it names none, bind the mesh by"
        " skel:skeleton (a Skeleton without joints suffices for blend shapes).",
    ),
    "MESH_HIDDEN": Code(
        "warning",
        "A mesh is invisible or of a purpose that is not drawn: controls that move only such meshes"
        " go to the board.",
        "Make it visible, and of purpose default or render, if it is a part of the face; else"
        " exclude the controls.",
    ),
    "MESH_OUTSIDE": Code(
        "warning",
        "A mesh with blend shapes or joint influences lies outside every SkelRoot, where USD"
        " does not deform meshes.",
        "Move it below the SkelRoot, or make a prim above both the SkelRoot.",
    ),
    "MESH_EMPTY": Code(
        "warning", "A mesh has no points and is ignored.", "Remove it or restore its points."
    ),
    "POINTS_ANIMATED": Code(
        "info",
        "A mesh has time samples on its points or topology; only those of the base pose are used.",
        "Nothing, if the base pose is the one wanted; else set `read.time`.",
    ),
    "PRIM_UNSUPPORTED": Code(
        "warning",
        "A prim other than a Mesh has blend shapes or joint influences; it is ignored.",
        "Convert it to a Mesh if it must carry controls.",
    ),
    "WEIGHTS_UNNORMALISED": Code(
        "warning",
        "Joint weights of a mesh do not add up to one, so that points shrink towards the origin.",
        "Normalise the weights.",
    ),
    "SKINNING_METHOD": Code(
        "warning",
        "The skinning method is unknown; classicLinear is taken.",
        "Author classicLinear or dualQuaternion.",
    ),
    "TOKEN_NOT_ANIMATED": Code(
        "info",
        "No SkelAnimation lists some blend shapes; they are laid out, but move only once one is"
        " authored.",
        "Add the names to the blendShapes of the SkelAnimation.",
    ),
    "TOKEN_REPEATED": Code(
        "warning",
        "A list names the same blend shape twice; the last is taken, as UsdSkel does.",
        "Remove the repetition.",
    ),
    "INBETWEEN_INVALID": Code(
        "warning",
        "An in-between has no weight, or one that another shape has; it is ignored.",
        "Give it a weight of its own other than 0 and 1.",
    ),
    "TOKEN_ORDER": Code(
        "info",
        "A mesh and its SkelAnimation list the same blend shapes in another order.",
        "Nothing for USD, which goes by name; use one order for applications that go by index.",
    ),
    "WEIGHTS_BEYOND_LIMITS": Code(
        "warning",
        "An animation has weights outside its own authored limits.",
        "Widen the limits, or correct the animation.",
    ),
    "RANGE_INVALID": Code(
        "warning",
        "An authored range is not a pair of ascending numbers; it is ignored.",
        "Correct it.",
    ),
    "POSES_MISMATCH": Code(
        "warning",
        "The list of pose names and the animation's frames differ in number.",
        "Name one pose per frame, the first being the rest pose.",
    ),
    "REST_MISSING": Code(
        "warning",
        "The Skeleton has no rest transforms; they are derived from the bind transforms.",
        "Author restTransforms.",
    ),
    "JOINT_MOTION_IGNORED": Code(
        "info",
        "The animation moves or scales joints besides turning them; only rotations become joint"
        " controls.",
        "Name its frames or clips as poses in the configuration to lay out the rest.",
    ),
    "CLIP_THINNED": Code(
        "info",
        "The animation is too long to keep whole; evenly spaced frames of it are kept.",
        "Nothing.",
    ),
    "UNITS_TYPE": Code(
        "warning",
        "metersPerUnit is not a double or not above zero.",
        "Author metersPerUnit as a positive double.",
    ),
    # --- glyphs ----------------------------------------------------------------------------------
    "GLYPH_MISSING": Code(
        "error",
        "A glyph that the configuration names does not exist.",
        "Correct the name: /PRIM for a prim of the asset, FILE</PRIM> for one of a file named from"
        " the asset's folder.",
        Exit.USAGE,
    ),
    "GLYPH_TYPE": Code(
        "error",
        "A glyph is neither a Mesh nor BasisCurves.",
        "Name a Mesh or BasisCurves, or convert the prim to one.",
        Exit.USAGE,
    ),
    "GLYPH_EMPTY": Code(
        "error",
        "A glyph has no points, too many, or all of them at one place.",
        "Give it a shape, of a thousand points at most.",
        Exit.USAGE,
    ),
    # --- settings --------------------------------------------------------------------------------
    "CONFIG_SYNTAX": Code(
        "error", "The configuration is not valid TOML.", "Correct the line named.", Exit.USAGE
    ),
    "CONFIG_UNKNOWN_KEY": Code(
        "error",
        "The configuration has a key that usdrigui does not know.",
        "Remove or correct the key; docs/settings.md lists all.",
        Exit.USAGE,
    ),
    "CONFIG_VALUE": Code(
        "error",
        "A setting has a value outside its range or of the wrong type.",
        "Correct the value.",
        Exit.USAGE,
    ),
    "CONFIG_UNKNOWN_CONTROL": Code(
        "error",
        "The configuration names a control that the asset does not have.",
        "Use a name listed by `usdrigui inspect`.",
        Exit.USAGE,
    ),
    "FIXED_IMPOSSIBLE": Code(
        "error",
        "The fixed anchors are infeasible.",
        "Free one of the controls named, or fix it elsewhere; --previous keeps what can be kept"
        " instead.",
        Exit.USAGE,
    ),
    "PREVIOUS_MISMATCH": Code(
        "error",
        "The layout given as --previous is of another character.",
        "Name the layer that was written for this asset; --like imitates another character's"
        " layout.",
    ),
    "PREVIOUS_RENAMED": Code(
        "info",
        "The character has another path than in the layout given as --previous; that layout is used"
        " all the same.",
        "Nothing, if the character was renamed or moved; for the layout of another character use"
        " --like instead.",
    ),
    "BASE_MISMATCH": Code(
        "error",
        "The layout given as --base is of another character.",
        "Name the layout layer of the asset that the shot references or sublayers.",
    ),
    "BASE_APART": Code(
        "error",
        "The shot does not compose the layout given as --base: it has the character at another"
        " path, or selects another variant than `rigUI = ui`.",
        "Let the shot reference the layout layer instead of the asset, or write that layer with"
        " --bare; select the variant `ui` of the set rigUI where another is.",
    ),
    "BASE_COMPLETE": Code(
        "info",
        "The layout given as --base has every control of the shot already; the layer adds none.",
        "Nothing; the layer can be deleted.",
    ),
    "INTERRUPTED": Code(
        "error", "The run was stopped before there was a result.", "Run it again.", Exit.LIMIT
    ),
    "RUN_TIME_LIMIT": Code(
        "error",
        "The run took longer than the limit and has no result.",
        "Raise `run.time_limit` (seconds).",
        Exit.LIMIT,
    ),
    "RUN_MEMORY_LIMIT": Code(
        "error",
        "The run needs more memory than the limit.",
        "Raise `run.memory_limit` (MiB).",
        Exit.LIMIT,
    ),
    "WORKER_LOST": Code(
        "error",
        "The process that does the work could not be started, or was killed from outside.",
        "Look for a memory limit of the machine or the farm, and run again.",
        Exit.LIMIT,
    ),
    "PYTHON_PERMISSION": Code(
        "error",
        "This user may not execute the Python interpreter with which processes are started.",
        "Let the user read and execute the file named and enter the folders above it, or run the"
        " command with another interpreter.",
        Exit.FILE,
    ),
    "WORKER_CRASHED": Code(
        "error",
        "The process that does the work crashed while it read no foreign file.",
        "Please report it with the asset and the command.",
        Exit.BUG,
    ),
    "OUTPUT_STREAM": Code(
        "error",
        "The result could not be written to standard output.",
        "Keep standard output open, and check that its target has free space.",
        Exit.FILE,
    ),
    "WORKING_DIRECTORY": Code(
        "error",
        "The working directory has been deleted.",
        "Change to a folder that exists.",
        Exit.FILE,
    ),
    # --- installation ----------------------------------------------------------------------------
    "USD_MISSING": Code(
        "error",
        "This Python has no USD (`pxr`).",
        "Install one: `pip install usd-core`; or run usdrigui with the Python of an application"
        " that brings USD.",
        Exit.USAGE,
    ),
    "USD_TWICE": Code(
        "warning",
        "Several installed packages hold the same files of `pxr`; the last one installed overwrote"
        " the others' files.",
        "Uninstall all of them but one, then install that one anew: `pip install --force-reinstall"
        " NAME`.",
    ),
    "EXTRA_MISSING": Code(
        "error",
        "An optional package that was asked for is not installed.",
        "Install it by the command that the message names.",
        Exit.USAGE,
    ),
    # --- controls --------------------------------------------------------------------------------
    "CONTROL_TINY": Code(
        "info",
        "The control moves so little that its slider is drawn enlarged.",
        "Exclude it in the configuration, or widen its range.",
    ),
    "CONTROL_DUPLICATE": Code(
        "info",
        "The control does the same as another one.",
        "Exclude one of the two in the configuration.",
    ),
    "PLACE_KEEPS_LITTLE": Code(
        "warning",
        "A control is placed where the configuration asks, and hardly moves the skin there.",
        "Ask for a place that it moves, or a larger `within`; `usdrigui check` lists the"
        " displacement that each element keeps.",
    ),
    "HANDLES_NARROWER": Code(
        "warning",
        "Handles are narrower than the configuration asks, since many controls crowd the part.",
        "Send some controls to the board, or raise `objective.max_neighbours` (8) little by little:"
        " wide handles take longer to solve and leave fewer controls on the part.",
    ),
    # --- viewer ----------------------------------------------------------------------------------
    "VIEW_MISMATCH": Code(
        "error",
        "The layout does not fit the rig shown with it, or one of them holds NaN or infinity.",
        "Process the asset again with `usdrigui process` and view the new layer.",
    ),
    # --- schema and layer ------------------------------------------------------------------------
    "EXTENSION_MISSING": Code(
        "error",
        "The Blender extension's files were not installed with the package.",
        "Install usdrigui again, from a wheel or a complete checkout.",
        Exit.USAGE,
    ),
    "SCHEMA_MISSING": Code(
        "error",
        "The schema's folder was not installed with the package.",
        "Install usdrigui again; `usdrigui schema-path` must print a folder.",
        Exit.USAGE,
    ),
    "SCHEMA_TOO_LATE": Code(
        "error",
        "The schema was registered after USD had built its registry, which has no effect.",
        "Register before any stage is opened, or set PXR_PLUGINPATH_NAME to the folder named.",
        Exit.USAGE,
    ),
    "LAYOUT_MISSING": Code(
        "error",
        "The layer holds no layout.",
        "Make one with `usdrigui process`, and name the layer that it wrote.",
    ),
    "LAYOUT_OFF": Code(
        "error",
        "The characters of the stage have layouts, but all of them are switched off. `check`"
        " reports it as info, also of a single character, and checks the asset.",
        "Select `rigUI = ui` on the prims named, or give `--variant rigUI=ui`.",
    ),
    "LAYOUT_INVALID": Code(
        "error",
        "A layout in the layer contradicts itself.",
        "Correct the property named (schemas/CONTRACT.md), or process the asset again.",
    ),
    "LAYOUT_VERSION": Code(
        "error",
        "A later usdrigui wrote the layout, in a schema version that this one does not know.",
        "Update usdrigui.",
    ),
    "SOURCE_UNREFERABLE": Code(
        "error",
        "No USD layer can refer to a file of this name.",
        "Rename the file, or write with --bare.",
        Exit.FILE,
    ),
    # --- writing ---------------------------------------------------------------------------------
    "FILE_FULL": Code(
        "error", "The disk has no space for the file.", "Free space and run again.", Exit.FILE
    ),
    "FILE_READ_ONLY": Code(
        "error",
        "The folder or file is read-only.",
        "Choose another place for it, or make this one writable.",
        Exit.FILE,
    ),
    "FILE_PERMISSION": Code(
        "error",
        "The file may not be written.",
        "Correct the permissions, or choose another place for it.",
        Exit.FILE,
    ),
    "FILE_TARGET": Code(
        "error", "The output cannot be a file of this name.", "Choose another name.", Exit.FILE
    ),
    "STUDY_RESULTS": Code(
        "error",
        "The file holds no valid results of the study.",
        "Give each CSV file that the page saved once.",
        Exit.FILE,
    ),
    "REVIEW_LAYER": Code(
        "error",
        "The file holds no review.",
        "Give a layer that *Save review* wrote in the page of this character.",
        Exit.FILE,
    ),
    "FILE_WRITE": Code(
        "error",
        "The file could not be written; its earlier content is untouched.",
        "See the message.",
        Exit.FILE,
    ),
    "FILE_ACCESS": Code(
        "error",
        "The operating system refused the use of a file or folder.",
        "See the message; no name may have more than 255 bytes.",
        Exit.FILE,
    ),
    "FILE_VERIFY": Code(
        "error",
        "The written file does not read back as the same content; the earlier file is untouched.",
        "Check the disk and run again.",
        Exit.FILE,
    ),
    # --- layouts inside the asset -----------------------------------------------------------------
    "ATTACH_PACKAGE": Code(
        "error",
        "A usdz is read-only for USD; no layer can be added to it.",
        "Unpack it and attach the layout to its root layer, or keep the layout beside it.",
    ),
    "ATTACH_LINK": Code(
        "error",
        "The asset is a symbolic link, from which the layout's path would lead elsewhere than from"
        " the file.",
        "Name the file itself.",
        Exit.FILE,
    ),
    "ATTACH_BUSY": Code(
        "error",
        "Another program is writing the asset, or another attach or detach is editing it; nothing"
        " was written.",
        "Wait until it is done and run again.",
        Exit.FILE,
    ),
    "ATTACH_HARD_LINK": Code(
        "error",
        "The asset's file has other names (hard links), which would keep the old content.",
        "Give the name a file of its own first (`cp CHAR COPY; mv COPY CHAR`), or edit a copy.",
        Exit.FILE,
    ),
    "ATTACH_ATTRIBUTES": Code(
        "error",
        "The edited asset could not be given the owner, group, access list or attributes that the"
        " asset has.",
        "Run as the owner of the file, or have the owner run it.",
        Exit.FILE,
    ),
    "ATTACH_NOT_BARE": Code(
        "error",
        "The layout has sublayers, which attaching would bring into the asset.",
        "Write it with `usdrigui process --bare`.",
    ),
    "ATTACH_MISMATCH": Code(
        "error",
        "The layout to attach is of another character.",
        "Name the layer that `usdrigui process --bare` wrote for this asset.",
    ),
    "ATTACH_OUTSIDE": Code(
        "error",
        "The layout refers to prims outside its SkelRoot, or is authored in a variant above it; a"
        " payload of the SkelRoot contains neither.",
        "Attach it without `--payload`, as a sublayer.",
    ),
    "ATTACH_CONTROLS_GONE": Code(
        "warning",
        "Elements of the layout to attach drive controls that the asset does not have.",
        "Run `usdrigui process --bare --previous` with the asset and the layout: a control that was"
        " renamed keeps its element.",
    ),
    "ATTACH_CYCLE": Code(
        "error",
        "The layout already sublayers the asset, so that each would contain the other.",
        "Write it with `usdrigui process --bare`, or detach it from the asset first.",
    ),
    # --- many assets ------------------------------------------------------------------------------
    "BATCH_NO_MATCH": Code(
        "error",
        "A pattern matches no asset.",
        "Correct it; put it in quotes, so that the shell leaves it alone.",
        Exit.USAGE,
    ),
    "BATCH_TIME_LIMIT": Code(
        "error",
        "An asset took longer than the batch allows.",
        "Raise --timeout, or process it alone.",
        Exit.LIMIT,
    ),
    "BATCH_KILLED": Code(
        "error",
        "The process of an asset was ended from outside.",
        "Look for a memory limit of the machine or the farm, and run again.",
        Exit.LIMIT,
    ),
    "BATCH_NO_REPORT": Code(
        "error",
        "The process of an asset ended without its report.",
        "Run `usdrigui process` on the asset alone to see its messages.",
        Exit.BUG,
    ),
    "BATCH_SCHEDULER": Code(
        "error",
        "No dask scheduler answers.",
        "Check the address and that the scheduler runs.",
        Exit.FILE,
    ),
    "BATCH_TOO_MANY": Code(
        "error", "There are more assets than one job can hold.", "Make several jobs.", Exit.USAGE
    ),
    # --- posing ----------------------------------------------------------------------------------
    "SOURCE_MISSING": Code(
        "error",
        "The layout layer does not sublayer any asset.",
        "Name the asset as its first sublayer, write the layer without --bare, or give a stage that"
        " composes both.",
    ),
    "LAYOUT_STALE": Code(
        "error",
        "The layout was made for another version of the character.",
        "Run `usdrigui process` on the character again.",
    ),
    "POSE_CONTROL": Code(
        "error",
        "A pose names a control that the character does not have.",
        "Use a name listed by `usdrigui inspect`.",
        Exit.USAGE,
    ),
    "POSE_VALUE": Code(
        "error",
        "A pose has a wrong number of values, or one that is not finite.",
        "Correct it.",
        Exit.USAGE,
    ),
    "NORMALS_INWARD": Code(
        "warning",
        "The faces of the character are wound so that their normals point inward.",
        "Correct the meshes' orientation attribute, or reverse their faces.",
    ),
    "TERM_INVALID": Code(
        "error",
        "A term of the objective from another package returned invalid costs.",
        "Correct the term, or leave it out of objective.terms.",
        Exit.USAGE,
    ),
    # --- layouts that exist -----------------------------------------------------------------------
    "ANIMATION_MISSING": Code(
        "error",
        "The character has no animation to show.",
        "Bind a SkelAnimation with time samples to it.",
    ),
    "CLIP_UNKNOWN_CONTROL": Code(
        "warning",
        "An animation moves blend shapes for which the character has no control.",
        "Give the animations of this character, or correct their blendShapes.",
    ),
    "CLIP_FOREIGN": Code(
        "error",
        "The animations given move no control of the character at all.",
        "Give animations of this character, or correct their blendShapes and joints.",
    ),
    "CONTROL_RENAMED": Code(
        "info",
        "A control of the earlier layout has another name now; its element stays.",
        "Nothing, if it is the same control; use its present name in the configuration.",
    ),
    "CONTROL_UNSURE": Code(
        "warning",
        "A control of the earlier layout may have another name now, but that is not sure: it is"
        " treated as removed.",
        "If it is the same control, set `controls.NAME.rename`, where NAME is its present name, to"
        " the earlier name.",
    ),
    "PIN_CARRIED": Code(
        "warning",
        "An element pinned by a person is anchored to another point now, at a slightly different"
        " place.",
        "Check its place; if it is wrong, give the control an `anchor`.",
    ),
    "PIN_LOST": Code(
        "warning",
        "A person's decision about an element cannot be kept on this rig.",
        "Decide again, with an `anchor` or `place` of the control.",
    ),
    "LAYOUT_MESH_GONE": Code(
        "error",
        "Elements are anchored to a mesh that the character does not have.",
        "In a shot, activate the mesh, or select `rigUI = none` for the character; if the asset has"
        " lost the mesh, run `usdrigui process` again.",
    ),
    "LAYOUT_TOPOLOGY": Code(
        "error",
        "The mesh under an element has other points or faces than when it was laid out.",
        "Run `usdrigui process` again, with --previous to keep what can be kept; in a shot of"
        " several characters, lay out only one that still fits its layout (`--set"
        " read.skel_root=PATH`).",
    ),
    "LAYOUT_ANCHOR_MOVED": Code(
        "warning",
        "The point under an element is no longer where it was.",
        "If the shape of the face has changed, run `usdrigui process` again, with --previous to"
        " keep what can be kept.",
    ),
    "LAYOUT_NONE": Code(
        "warning",
        "A character of the stage has no layout, while another has one.",
        "Run `usdrigui process` on its asset and compose that layout with it, if it is to be"
        " animated; name the other with `read.skel_root` to check that alone.",
    ),
    "LAYOUT_CONTROL_GONE": Code(
        "error",
        "An element drives a control that the rig does not have.",
        "Run `usdrigui process` on the character again, with --previous: a control that was"
        " renamed keeps its element.",
    ),
    "LAYOUT_CONTROL_NEW": Code(
        "warning",
        "The rig has a control that the layout does not know.",
        "Run `usdrigui process` again.",
    ),
    "LAYOUT_HANDLES_COLLIDE": Code(
        "warning",
        "Two handles are nearer than a handle's width: one covers the other.",
        "Move one of them, or run `usdrigui process` again.",
    ),
    "LAYOUT_ANCHOR_HIDDEN": Code(
        "warning",
        "No view shows the point that an element is anchored to.",
        "Move the element to where it can be seen.",
    ),
    "LAYOUT_BETTER_PLACE": Code(
        "info",
        "An element would have a lower cost at another place.",
        "Set the control's `anchor` to the place named, if you agree.",
    ),
    # --- solving ---------------------------------------------------------------------------------
    "SOLVE_INFEASIBLE": Code(
        "error",
        "No layout keeps all handles apart.",
        "Allow places on the board (objective.off_face_allowed), make handles smaller or prune"
        " fewer candidates.",
    ),
    "SOLVE_EXTRA": Code(
        "error",
        "The method needs a package that is not installed.",
        "Install pytoulbar2, or use the method highs.",
        Exit.USAGE,
    ),
    "EXPLANATION_FAILED": Code(
        "warning",
        "A bug of usdrigui kept it from explaining the layout; the layout itself is valid.",
        "Please report it with the asset and the command.",
    ),
    # --- ours ------------------------------------------------------------------------------------
    "BUG": Code(
        "error",
        "A bug of usdrigui ended the run.",
        "Please report it with the asset and the command.",
        Exit.BUG,
    ),
}
CODES: Mapping[str, Code] = MappingProxyType(_CODES)
