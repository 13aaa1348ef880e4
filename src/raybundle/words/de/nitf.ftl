nitf-no_image = Die NITF-Datei enthält kein Bild.
    .do = Prüfen, ob es die richtige Datei ist.

nitf-no_rpc = Das erste Bild der NITF-Datei hat kein RPC00B.
    .do = Die Datei mit dem RPC angeben (.XML, .RPB).

nitf-rpc_invalid = { $name } ist unvollständig oder ungültig (SUCCESS { $success }).
    .do = Die Datei neu beschaffen oder eine mit dem RPC angeben (.XML, .RPB).

nitf-field = Das NITF-Feld { $name } ist { $value }, nicht { $n } Ziffern.
    .do = Die Datei neu beschaffen; sie ist beschädigt.
