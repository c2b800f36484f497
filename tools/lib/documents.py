"""Text that tools write into the documentation, between two marks."""
import re
import sys


def between(path, begin, end, text):
    """The file at path with what stands between two marks replaced."""
    whole = path.read_text(encoding="utf-8")
    pattern = re.compile(re.escape(begin) + r"\n.*?" + re.escape(end), re.S)
    if not pattern.search(whole):
        sys.exit(f"{path} has no marks '{begin}' and '{end}'")
    return pattern.sub(lambda _: f"{begin}\n{text}\n{end}", whole)


def write_or_check(wanted, check, remedy):
    """Writes {path: text} where it differs; with check, writes nothing, names what is stale and returns 1."""
    stale = [path for path, text in wanted.items() if not path.exists() or path.read_text(encoding="utf-8") != text]
    for path in stale:
        if check:
            print(f"{path.name} is not up to date; run {remedy}", file=sys.stderr)
        else:
            path.write_text(wanted[path], encoding="utf-8")
    return 1 if stale and check else 0
