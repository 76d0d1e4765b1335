"""What the program starts to have results shown: python3 -I show.py page|site|protocol|picture FROM TO

Says in one sentence on standard error what is wrong. Exit 2: the input; 1: it cannot be written;
3: a Debian package is missing, which is named.
"""
import importlib.util
import pathlib
import sys

NEEDED = {"numpy": "python3-numpy", "h5py": "python3-h5py", "matplotlib": "python3-matplotlib",
          "jinja2": "python3-jinja2"}

def missing(*more):
    """The Debian packages that are not there."""
    needed = NEEDED | dict(more)
    return [package for module, package in needed.items() if importlib.util.find_spec(module) is None]

def main(words):
    what, source, target = words
    lack = missing(*([("markdown", "python3-markdown")] if what == "site" else []))
    if lack:
        print(f"pages and pictures need Debian packages that are not there: apt-get install "
              f"{' '.join(lack)}", file=sys.stderr)
        return 3
    sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))  # ours, and no other folder
    from clothbench import page, results
    try:
        if what == "page":
            text = page.report(source)
            page.write(target, text)
            print(f"{target}: one page, {len(text.encode()) // 1000} kB")
        elif what == "protocol":
            page.write(target, page.protocol(source))
        elif what == "picture":
            page.picture(source, target)
        else:
            from clothbench import site
            site.make(source, target)
            print(f"{target}: a site; begin with its index.html")
    except results.Bad as bad:
        print(bad, file=sys.stderr)
        return 1 if "written" in str(bad) else 2
    return 0

if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
