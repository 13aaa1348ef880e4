kalibr-no_camera = Die Datei hat keine Kamera cam0.
    .do = Die Camchain von Kalibr angeben.
