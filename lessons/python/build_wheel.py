"""Builds a wheel where pip asks for one (PEP 517). CMake does the work, and nothing is downloaded."""
import base64
import hashlib
import os
import re
import subprocess
import sys
import sysconfig
import tempfile
import zipfile
from pathlib import Path


def _folder(python):
    """build/, if that is for this Python; else a folder in it. Configured, so that what was installed since is found."""
    cache = Path("build/CMakeCache.txt")
    built_for = re.search("REDERIVE_PYTHON:FILEPATH=(.*)", cache.read_text()) if cache.exists() else None
    here = os.path.realpath(built_for[1] if built_for else "/usr/bin/python3") == python
    folder = Path("build" if here else f"build/{sys.implementation.cache_tag}")
    how = [folder] if (folder / "CMakeCache.txt").exists() else ["--preset", "default", "-DREDERIVE_BUILD_TESTS=OFF", "-B", folder]
    subprocess.run(["cmake", *how, f"-DREDERIVE_PYTHON:FILEPATH={python}"], check=True)
    return folder


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    folder = _folder(os.path.realpath(sys.executable))
    subprocess.run(["cmake", "--build", folder, "--target", "python_module"], check=True)
    version = re.search(r"project\(rederive VERSION ([0-9.]+)", Path("CMakeLists.txt").read_text())[1]
    abi = f"cp{sys.version_info[0]}{sys.version_info[1]}"
    tag = f"{abi}-{abi}-{re.sub('[-.]', '_', sysconfig.get_platform())}"
    info, name = f"rederive-{version}.dist-info", f"rederive-{version}-{tag}.whl"
    with tempfile.TemporaryDirectory() as stage:
        subprocess.run(["cmake", "--install", folder, "--component", "python", "--strip", "--prefix", stage], check=True)
        files = {f"rederive/{path.name}": path.read_bytes() for path in Path(stage).glob("lib/python*/*/rederive/*")}
    files[f"{info}/METADATA"] = (f"Metadata-Version: 2.1\nName: rederive\nVersion: {version}\nRequires-Python: >=3.9\n"
                                 "License: GPL-3.0-or-later\nRequires-Dist: numpy\nProvides-Extra: papers\n"
                                 "Requires-Dist: sympy>=1.11; extra == 'papers'\n"
                                 "Requires-Dist: scipy; extra == 'papers'\n").encode()
    files[f"{info}/WHEEL"] = f"Wheel-Version: 1.0\nGenerator: rederive\nRoot-Is-Purelib: false\nTag: {tag}\n".encode()
    record = "".join(f"{file},sha256={base64.urlsafe_b64encode(hashlib.sha256(text).digest()).decode().rstrip('=')},"
                     f"{len(text)}\n" for file, text in sorted(files.items()))
    files[f"{info}/RECORD"] = (record + f"{info}/RECORD,,\n").encode()
    with zipfile.ZipFile(Path(wheel_directory) / name, "w", zipfile.ZIP_DEFLATED) as wheel:
        for file, text in sorted(files.items()):
            wheel.writestr(zipfile.ZipInfo(file), text, zipfile.ZIP_DEFLATED)  # dated 1980: the same bytes each time
    return name
