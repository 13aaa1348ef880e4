"""`python -m raybundle`: the command line."""

import sys

from raybundle.cli.main import main

if __name__ == "__main__":
    sys.exit(main())
