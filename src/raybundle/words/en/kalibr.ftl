kalibr-no_camera = The file has no camera cam0.
    .do = Give the camchain of Kalibr.
