"""Reads each notebook that argv[2:] names, which must be valid, runs it in the folder argv[1] by one kernel and writes it back."""
import json, sys, nbformat
from jupyter_client.manager import KernelManager
from nbclient import NotebookClient
kernel = KernelManager(kernel_name="python3")
kernel.start_kernel(cwd=sys.argv[1])
try:
    for file in sys.argv[2:]:
        notebook = nbformat.read(file, 4)
        nbformat.validate(notebook)
        NotebookClient(notebook, km=kernel, timeout=3000).execute()
        json.dump(notebook, open(file, "w"))
finally:
    kernel.shutdown_kernel(now=True)
