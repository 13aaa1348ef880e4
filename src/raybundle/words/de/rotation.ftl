rotation-quaternion = { $kind ->
        [image] Bild
        [rig] Rig
       *[frame] Frame
     } { $name }: Das Quaternion hat keine Richtung.
    .do = Die Datei neu exportieren.

rotation-not_orthogonal = Die Drehmatrix ist nicht orthogonal mit Determinante 1.
    .do = Die Datei neu exportieren.

rotation-too_large = Eine Drehung überschreitet { $limit_rad } rad.
    .do = Die Datei neu exportieren.
