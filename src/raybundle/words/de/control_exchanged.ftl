control_exchanged = Passpunkte { $first } und { $second } sind wohl vertauscht; { $few ->
     [yes] kein Passpunkt geht in die Ausgleichung ein (weniger als { $least } Punkte bleiben)
     *[no] beide gehen nicht in die Ausgleichung ein
    }.
    .why = Die beiden Punkte liegen { NUM($before_m, digits: 2) } m von dem Ort, den die anderen ergeben, vertauscht { NUM($after_m, digits: 2) } m.
    .do = Die Koordinaten der beiden Punkte oder ihre Namen in den Bildern vertauschen.
