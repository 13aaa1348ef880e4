mission_camera-not_positive = Kamera { $camera }: { $entry } ist { $value }.
    .do = Einen Wert über 0 angeben.
