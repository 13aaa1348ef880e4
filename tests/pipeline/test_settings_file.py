"""project.toml rewritten: one table changes, all others stay, whatever stands in them."""

import tomllib

import pytest
from hypothesis import given
from hypothesis import strategies as st

from raybundle.errors import InputError
from raybundle.pipeline.settings_file import with_table

HOSTILE = [
    """[record]\nplace = "\'\'\'\\"\\"\\"[x]"\n\n[foreign]\na = 1\n\n[[tool.list]]\nb = 2\n""",
    '''[other]\ntext = """\n[record]\nnot = "this"\\\n"""\n[record]\nclient = 'C'\n[foreign]\nb = 2\n''',
    """[other]\ntext = '''\n[record]\n''''\n[record]\nclient = "C # no comment"\n[foreign] # [record]\nb = 2\n""",
    """["record"]\nclient = "C"\n[foreign]\nx = "\\\\"\n""",
    '''[foreign]\n# """ a comment\na = "it's"\n[record]\nclient = "C"\n''',
    '''x = """ends with a quote"""" \n[record]\nclient = "C"\n[last]\na = ["[record]", """\n[record]"""]\n''',
]


@pytest.mark.parametrize("text", HOSTILE)
def test_other_tables_stay_whatever_they_hold(text, tmp_path):
    file = tmp_path / "project.toml"
    file.write_text(text)
    before = tomllib.loads(text)
    after = tomllib.loads(with_table(file, "record", '[record]\nclient = "New"'))
    assert after.pop("record") == {"client": "New"}
    before.pop("record", None)
    assert after == before


@given(st.dictionaries(st.sampled_from(["a", "b", "c"]), st.text(max_size=30), max_size=3))
def test_texts_of_any_kind_survive(tmp_path_factory, values):
    import json

    file = tmp_path_factory.mktemp("t") / "project.toml"
    lines = [f"{k} = {json.dumps(v)}" for k, v in values.items()]
    text = "\n".join(["[foreign]", *lines, "", "[record]", *lines, "", "[[tool.list]]", *lines]) + "\n"
    try:
        before = tomllib.loads(text)
    except tomllib.TOMLDecodeError:
        return
    file.write_text(text, encoding="utf-8")
    try:
        after = tomllib.loads(with_table(file, "record", '[record]\nclient = "New"'))
    except InputError:
        return  # nothing is lost
    assert {k: v for k, v in after.items() if k != "record"} == {k: v for k, v in before.items() if k != "record"}
