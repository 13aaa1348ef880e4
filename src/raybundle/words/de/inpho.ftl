inpho-not_closed = Der letzte Satz PHOTO ist nicht mit END geschlossen: Die Datei ist unvollständig.
    .do = Die Datei erneut kopieren.
