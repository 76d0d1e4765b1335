"""One corpus of files that somebody broke, or made on purpose, for both readers: the program's (tables by
`verify --from`, results by `score`) and the package's. What one refuses the other refuses, with the same
words; nothing that a name has reaches a terminal as control characters; nobody waits for a pipe."""
import os
import subprocess

import h5py
import numpy as np
import pytest
from test_results import seal

from clothbench import page, program, results
from clothbench.results import Bad

def told(*words):
    """(exit code, sentence) of the program."""
    done = subprocess.run([program.find(), *words], capture_output=True, text=True, check=False, timeout=60)
    assert not any(c < " " and c not in "\n\t" for c in done.stderr + done.stdout)
    return done.returncode, done.stderr

# --- tables: bytes, and the words of both sentences; None: both read it --------------------------

def as_pipe(path):
    os.mkfifo(path)

def as_link(path):
    path.with_name("there").write_text("a\n1\n")
    path.symlink_to("there")

@pytest.mark.parametrize("made, words", [
    (b"case,model,end\n1,2\n", "fall.csv:2: 2 cells below 3 keys"),
    (b"a,b\n1,2\n\nc,d\n3\n", "fall.csv:5: 1 cells below 2 keys"),
    (b'# c\n\na\n"1\n2"\n3,4\n', "fall.csv:6: 2 cells below 1 keys"),
    (b'a\n"no end\n', "fall.csv:2: a quote has no end"),
    (b'a\n"x"y\n', "fall.csv:2: a quote has no end, or words behind it"),
    (b"a\n1\0\n", "has a byte 0"),
    (as_pipe, "regular file|pipe"), (os.mkdir, "regular file|directory"), (as_link, "symbolic link"),
    (b"", None), (b"# words alone\n", None), (b"a,b\n1,inf\nnan,\n", None), (b"a,b\r\n1,2\r\n", None),
    (b'a,b\n"x\033[2J",\xff\n', None), (b"a," * 20000 + b"a\n" + b"1," * 20000 + b"1\n", None),
])
def test_tables(tmp_path, made, words):
    path = tmp_path / "fall.csv"
    if callable(made):
        made(path)
    else:
        path.write_bytes(made)
    code, said = told("verify", "fall", "--from", tmp_path)
    try:
        ours = "read" if results.tables(path) else ""
    except Bad as bad:
        ours = str(bad)
    if words:
        assert code in (1, 2) and all(any(w in text for w in words.split("|")) for text in (said, ours)), (said, ours)
    else:
        assert ours == "read" or "has no table" in ours
        assert not any(w in said for w in ("cells below", "quote", "byte")), said

# --- results -------------------------------------------------------------------------------------

FRAMES = np.zeros((2, 2, 100, 100, 3)) + np.linspace(0, 1, 100)[:, None]

def plain(file, **options):
    file.create_dataset("xyz", data=FRAMES, **options)

def linked(file, link):
    file["elsewhere"] = FRAMES
    file["xyz"] = link

def outside(file):
    file.create_dataset("xyz", FRAMES.shape, "f8", external=[("/etc/hostname", 0, h5py.h5f.UNLIMITED)])

def virtual(file):
    layout = h5py.VirtualLayout(FRAMES.shape, "f8")
    file["plain"] = FRAMES
    layout[:] = h5py.VirtualSource(".", "plain", FRAMES.shape)
    file.create_virtual_dataset("xyz", layout)

def huge_pieces(file):
    file.create_dataset("xyz", FRAMES.shape, "f8", chunks=(1 << 7, 2, 100, 100, 3), maxshape=(None, 2, 100, 100, 3),
                        compression=1)[0] = 1

def other_numbers(value):
    def make(file):
        data = FRAMES.copy()
        data[1, 0, 7, 7, 0] = value
        file["xyz"] = data
    return make

TRUSTED = "(no xyz|that stand in the file itself"

@pytest.mark.parametrize("make, words", [
    (outside, TRUSTED), (virtual, TRUSTED), (huge_pieces, TRUSTED),
    (lambda file: file.create_dataset("xyz", FRAMES.shape, "f8"), TRUSTED),  # never written
    (lambda file: file.create_group("xyz"), TRUSTED),
    (lambda file: file.create_dataset("xyz", data=["a", "b"]), TRUSTED),
    (lambda file: linked(file, h5py.SoftLink("/elsewhere")), TRUSTED),
    (lambda file: linked(file, h5py.ExternalLink("other.h5", "xyz")), TRUSTED),
    (lambda file: file.create_dataset("xyz", data=FRAMES[:, :, :, :, :2]), "xyz"),
    (plain, None), (lambda file: plain(file, chunks=(1, 2, 100, 100, 3)), None),
    (lambda file: plain(file, chunks=(1, 2, 100, 100, 1), compression=1), None),
    (other_numbers(np.nan), None), (other_numbers(np.inf), None), (other_numbers(1e300), None),
])
def test_results(tmp_path, make, words):
    path = tmp_path / "a\033[2J.h5"
    with h5py.File(path, "w", userblock_size=512) as file:
        make(file)
        file["xyz_time"] = [0.1, 0.5]
        file.attrs.update({"scene_name": "free_fall\033[2J", "model": "iga", "length": 1.0, "format": "clothbench run 2"})
    seal(path)
    code, said = told("score", "free_fall", path)
    try:
        ours = "read" if results.run(path) else ""
    except Bad as bad:
        ours = str(bad)
    if words:
        assert code in (1, 2) and all(any(w in text for w in words.split("|")) for text in (said, ours)), (said, ours)
    else:
        assert ours == "read" and "stand in" not in said, (said, ours)
        text = page.report(tmp_path)
        assert "<img" in text or "cannot be" in text or "nan" not in text.lower()

def test_damaged(tmp_path):
    """One bit of a result, a file that is none, and one whose end is missing."""
    path = tmp_path / "r.h5"
    with h5py.File(path, "w", userblock_size=512) as file:
        plain(file)
        file["xyz_time"] = [0.1, 0.5]
    seal(path)
    whole = path.read_bytes()
    for data, words in [(whole[:-100] + bytes([whole[-100] ^ 1]) + whole[-99:], "damaged"), (whole[:-9], "damaged"),
                        (b"no HDF5\n" * 100, "no |not ")]:
        path.write_bytes(data)
        with pytest.raises(Bad) as bad:
            results.run(path)
        code, said = told("score", "free_fall", path)
        assert code == 2 and all(any(w in text for w in words.split("|")) for text in (said, str(bad.value))), (said, bad)
