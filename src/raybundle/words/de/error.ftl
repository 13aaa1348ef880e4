error-other = Ursache: { $detail }
    .do = Diese Ursache beheben, dann den Befehl erneut ausführen.
