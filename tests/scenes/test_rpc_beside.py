"""Files beside a picture that hold its RPC, by their names."""

import pytest

from raybundle.io.scenes.rpc_text import write_rpc_text
from raybundle.workflows.scenes.images import model_of


@pytest.mark.parametrize(
    "end", ["_RPC.TXT", "_rpc.txt", "_RPC.txt", ".RPB", ".rpb", ".RPC", ".rpc", "_rpc.rpc", ".geom"]
)
@pytest.mark.parametrize("stem", ["scene", "scene.v2", "a b"])
def test_an_rpc_beside_its_picture_is_found(tmp_path, rpc, stem, end):
    picture, beside = tmp_path / f"{stem}.jp2", tmp_path / f"{stem}{end}"
    picture.touch()
    assert model_of(picture) is None
    write_rpc_text(rpc, beside)
    assert model_of(picture) == beside
