"""Installed, by CMake or pip, the module stands alone: nothing of the build folder is needed."""
import os
import subprocess
import sys
from pathlib import Path

import pytest

SOURCE, BUILD = Path(__file__).parents[3], Path(os.environ["REDERIVE_PROGRAMS"]).parent
LIBRARY = f"lib/python{sys.version_info[0]}.{sys.version_info[1]}/dist-packages"


def by_cmake(prefix):
    subprocess.run(["cmake", "--install", BUILD, "--component", "python", "--prefix", prefix], check=True)


def installed_there(folder):
    by_cmake(folder / "usr/local")
    return folder / "usr/local" / LIBRARY


def installed_by_the_system(folder):
    by_cmake(folder / "usr")
    return folder / "usr/lib/python3/dist-packages"


def installed_by_pip(folder):
    subprocess.run([sys.executable, "-m", "pip", "install", "--no-index", "--no-deps", "--no-build-isolation", "--target",
                    folder, SOURCE], check=True, env=os.environ | {"PIP_ROOT_USER_ACTION": "ignore"})
    return folder


# pip builds in build/: elsewhere that would be another build
WAYS = [installed_there, installed_by_the_system] + [installed_by_pip] * (BUILD == SOURCE / "build")


@pytest.mark.parametrize("install", WAYS)
def test_an_installed_module_stands_alone(install, tmp_path):
    folder = install(tmp_path / "root")
    moved = tmp_path / "elsewhere"
    folder.rename(moved)
    assert not any(file.is_symlink() for file in (moved / "rederive").iterdir())
    text = "import rederive as r; print(r.__file__, r.threshold(r.Pulse(3)).code, len(r.ledger()), r.emit('python', " \
           "'restitution')(0.25))"
    said = subprocess.run([sys.executable, "-c", text], capture_output=True, text=True, cwd=tmp_path,
                          env={"PYTHONPATH": str(moved), "PYTHONDONTWRITEBYTECODE": "1"})
    assert said.stdout.split()[:2] == [str(moved / "rederive/__init__.py"), "2"], said.stderr


def test_the_places_are_where_this_python_looks():
    assert f"/usr/local/{LIBRARY}" in sys.path and "/usr/lib/python3/dist-packages" in sys.path
