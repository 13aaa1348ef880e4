control_exchanged = Passpunkte { $first } und { $second } sind wohl vertauscht; { $few ->
     [yes] kein Passpunkt nimmt teil (weniger als { $least } Punkte bleiben)
     *[no] sie nehmen nicht teil
    }.
    .why = Sie liegen { NUM($before_m, digits: 2) } m von dem Ort, den die anderen ergeben, vertauscht { NUM($after_m, digits: 2) } m.
    .do = Ihre Koordinaten oder ihre Namen in den Bildern vertauschen.
