"""The page as a reader of layouts: ``page.py LAYER``, with questions on standard input."""

import base64
import json
import subprocess
import sys
from pathlib import Path

from pxr import Usd

import usdrigui
from usdrigui.errors import RigUIError
from usdrigui.settings.loading import load_beside
from usdrigui.view.web.packing import pack

questions = json.load(sys.stdin)
try:
    scene = base64.b64encode(
        pack(usdrigui.open(Usd.Stage.Open(sys.argv[1]), load_beside(Path(sys.argv[1]))).characters, "")
    ).decode()
except RigUIError:  # the page is never made
    print(json.dumps([{"refused": True}] * len(questions)))
    sys.exit()
program = Path(__file__).with_suffix(".mjs")
done = subprocess.run(
    ["node", str(program)], input=json.dumps({"scene": scene, "questions": questions}), text=True, check=True,
    stdout=subprocess.PIPE,
)  # fmt: skip
print(done.stdout)
