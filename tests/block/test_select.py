"""Parts of a block keep what belongs together."""

import numpy as np

from raybundle.block import Attitudes, Stations
from raybundle.block.select import attitudes_of, stations_of


def test_rows_of_stations_and_attitudes_keep_all_their_columns():
    keep = np.array([True, False, True])
    image = np.array([4, 5, 6], np.int32)
    stations = stations_of(
        Stations(
            image=image, xyz=np.arange(9.0).reshape(3, 3), sigma=np.ones((3, 3)),
            antenna=np.array([7, -1, 8], np.int32), time=np.array([0.0, 1.0, 2.0]),
            velocity=np.arange(9.0).reshape(3, 3) * 10,
        ),
        keep,
    )  # fmt: skip
    assert stations.image.tolist() == [4, 6]
    assert stations.antenna.tolist() == [7, 8]
    assert stations.time.tolist() == [0.0, 2.0]
    assert stations.velocity[1].tolist() == [60.0, 70.0, 80.0]
    attitudes = attitudes_of(
        Attitudes(image=image, angles=np.arange(9.0).reshape(3, 3), sigma=np.ones((3, 3)), imu=np.array([1, 2, 3])),
        keep,
    )
    assert attitudes.imu.tolist() == [1, 3]
    assert attitudes.angles[1].tolist() == [6.0, 7.0, 8.0]
    assert attitudes_of(Attitudes(image=image, angles=np.zeros((3, 3)), sigma=np.ones((3, 3))), keep).imu is None
