"""Draw a layer by Hydra Storm, as usdrecord does, with the guides and without; saves both pictures.

Needs the USD that bpy brings along, and a GL context without a window.
"""

import ctypes
from pathlib import Path

import bpy
from scene import job

bpy.utils.expose_bundled_modules()
from pxr import Gf, Sdf, Usd, UsdAppUtils, UsdGeom  # noqa: E402


def gl_context():
    """A current OpenGL context of EGL that draws on no surface."""
    egl = ctypes.CDLL("libEGL.so.1")
    for name in ("eglGetPlatformDisplay", "eglCreateContext"):
        getattr(egl, name).restype = ctypes.c_void_p
    display = ctypes.c_void_p(egl.eglGetPlatformDisplay(0x31DD, None, None))
    assert egl.eglInitialize(display, None, None), "EGL cannot be initialised"
    assert egl.eglBindAPI(0x30A2)
    wanted = (ctypes.c_int * 5)(0x3040, 0x0008, 0x3033, 0x0001, 0x3038)
    config, count = ctypes.c_void_p(), ctypes.c_int()
    assert egl.eglChooseConfig(display, wanted, ctypes.byref(config), 1, ctypes.byref(count))
    assert count.value
    version = (ctypes.c_int * 7)(0x3098, 4, 0x30FB, 5, 0x30FD, 2, 0x3038)
    made = ctypes.c_void_p(egl.eglCreateContext(display, config, None, version))
    assert made.value, "no OpenGL 4.5"
    assert egl.eglMakeCurrent(display, None, None, made)


def main(task):
    """One picture per frame and choice of guides, beside the result."""
    gl_context()
    stage = Usd.Stage.Open(task["layer"])
    stage.SetEditTarget(stage.GetSessionLayer())
    camera = UsdGeom.Camera.Define(stage, Sdf.Path("/Camera"))
    camera.AddTranslateOp().Set(Gf.Vec3d(*task["eye"]))
    camera.CreateFocalLengthAttr(50.0)
    camera.CreateClippingRangeAttr(Gf.Vec2f(0.1, 1000.0))
    for guides in (False, True):
        recorder = UsdAppUtils.FrameRecorder()
        recorder.SetRendererPlugin("HdStormRendererPlugin")
        recorder.SetImageWidth(480)
        recorder.SetIncludedPurposes(["guide"] if guides else [])
        for frame in task["frames"]:
            name = f"{'guides' if guides else 'plain'}{frame}.png"
            recorder.Record(stage, camera, frame, str(Path(task["result"]).with_name(name)))


main(job())
