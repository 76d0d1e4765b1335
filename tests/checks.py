"""What tests in Python share: checks that are counted, and sentences that must be said."""
import sys

sys.dont_write_bytecode = True
failures = 0


def check(what, holds):
    global failures
    if not holds:
        failures += 1
        print("does not hold: " + what)


def says(what, kind, words, call, *arguments):
    """call(*arguments) raises `kind` with these words in its sentence."""
    try:
        call(*arguments)
        check(f"{what}: is taken", False)
    except kind as error:
        check(f"{what}: '{words}' is not in '{error}'", words in str(error))


def finish():
    print(f"{failures} failed")
    sys.exit(failures > 0)
