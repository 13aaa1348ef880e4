parameter-unknown = { $name } ist kein Parameter von { $model }.
    .do = Einen von { LIST($known, most: 20) } verwenden.

parameter-twice = Der Parameter { $name } kommt zweimal vor.
    .do = Eine Angabe löschen.

parameter-no_list = { $value } ist keine Liste von Parametern.
    .do = Eine Liste aus { LIST($known, most: 20) } angeben.

parameter-sigma_not_positive = Die Standardabweichung von { $name } ist { $sigma }.
    .do = Einen Wert über 0 angeben oder { $name } aus estimate entfernen, um ihn festzuhalten.

parameter-sigma_of_fixed = { $name } hat eine Standardabweichung, ist aber festgehalten.
    .do = Den Parameter in estimate aufnehmen oder seine Standardabweichung löschen.

parameter-unknown_camera = { $way ->
        [free] { OPTION("free") }
       *[hold] { OPTION("hold") }
     }: Die Kamera { $camera } ist nicht im Block.
    .do = Eine dieser Kameras angeben: { $known }.

parameter-free_and_held = Der Parameter { $symbol } der Kamera { $camera } ist als frei und als festgehalten gewählt.
    .do = Den Parameter aus { OPTION("free") } oder aus { OPTION("hold") } entfernen.

parameter-not_of_camera = { $way ->
        [free] { OPTION("free") }
       *[hold] { OPTION("hold") }
     }: Die Kamera { $camera } hat keinen Parameter { $symbol }.
    .do = Einen von { LIST($known, most: 20) } angeben.
