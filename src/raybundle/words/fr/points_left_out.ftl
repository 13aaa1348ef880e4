points_left_out = { $n } points ont été exclus : les rayons ne se coupent pas.
