"""kill -9 while measuring."""

import pytest

from raybundle.io.block.folder import read_block
from tests.studio.killed import measure_under_kills


@pytest.mark.long
def test_no_acknowledged_action_is_lost_and_none_counts_twice(project):
    image = read_block(project / "result" / "block").images.ids[0]
    told = measure_under_kills(project, image, kills=4, seed=1)
    assert told["actions"] > 20
