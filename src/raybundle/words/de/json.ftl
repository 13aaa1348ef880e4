json-invalid = Das ist kein gültiges JSON: { $detail } (Zeichen { $character }).
    .do = { $cut ->
        [yes] Die Datei neu beschaffen: Das Ende fehlt
       *[no] Diese Zeile korrigieren
     }.

json-key_twice = Der Schlüssel { $name } kommt in einem Objekt zweimal vor.
    .do = Einen der beiden löschen.

json-not_finite = { $value } ist in JSON keine Zahl.
    .do = Eine endliche Zahl oder null angeben.
