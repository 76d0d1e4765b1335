"""What the program starts to have results shown: python3 -I show.py page|site|protocol|picture|usd
FROM TO

Says in one sentence on standard error what is wrong. Exit 2: the input; 1: it cannot be written;
3: a Debian package is missing, which is named.
"""
import importlib.util
import pathlib
import sys

NEEDED = {"usd": ["numpy"], "site": ["numpy", "h5py", "matplotlib", "jinja2", "markdown"]}

def main(words):
    what, source, target = words
    if lack := [f"python3-{module}" for module in NEEDED.get(what, NEEDED["site"][:-1])
                if importlib.util.find_spec(module) is None]:
        print(f"Debian packages are missing: apt-get install {' '.join(lack)}", file=sys.stderr)
        return 3
    sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))  # ours, and no other folder
    from clothbench import results
    try:
        if what == "site":
            from clothbench import site
            site.make(source, target)
            print(f"{target}: a site; begin with its index.html")
        elif what == "usd":
            from clothbench import usd
            results.write(target, usd.text_of(source))
        else:
            from clothbench import page
            data = {"page": page.report, "protocol": page.protocol, "picture": page.picture}[what](source)
            results.write(target, data)
            if what == "page":
                print(f"{target}: one page, {len(data.encode()) // 1000} kB")
    except results.Bad as bad:
        print(bad, file=sys.stderr)
        return 1 if "written" in str(bad) else 2
    return 0

if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
