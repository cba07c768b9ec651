"""make_wheel.py PACKAGE VERSION FOLDER: a wheel of the built package, by `wheel pack`."""

import pathlib
import shutil
import subprocess
import sys
import sysconfig
import tempfile

package, version, folder = sys.argv[1:]
interpreter = f"cp{sys.version_info.major}{sys.version_info.minor}"
platform = sysconfig.get_platform().replace("-", "_").replace(".", "_")
with tempfile.TemporaryDirectory() as temporary:
    top = pathlib.Path(temporary)
    shutil.copytree(package, top / "kinegraph", ignore=shutil.ignore_patterns("__pycache__"))
    info = top / f"kinegraph-{version}.dist-info"
    info.mkdir()
    (info / "METADATA").write_text(f"""Metadata-Version: 2.1
Name: kinegraph
Version: {version}
Summary: Planar mechanisms solved at the drawing board, exactly
License: MIT
Requires-Python: >=3.11
Requires-Dist: numpy
Provides-Extra: frames
Requires-Dist: pandas; extra == "frames"
""")
    (info / "WHEEL").write_text(f"""Wheel-Version: 1.0
Generator: kinegraph
Root-Is-Purelib: false
Tag: {interpreter}-{interpreter}-{platform}
""")
    subprocess.run([sys.executable, "-m", "wheel", "pack", str(top), "-d", folder], check=True)
