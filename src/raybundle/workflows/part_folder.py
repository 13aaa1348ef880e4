"""Where the results of further parts lie."""


def part_folder(k: int) -> str:
    """Folder of the result of the k-th further part."""
    return f"result-{k + 2}"
