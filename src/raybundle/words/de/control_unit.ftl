control_unit = Die Höhen der Passpunkte sind wohl in Fuß; kein Passpunkt geht in die Ausgleichung ein.
    .why = Die { $n } Punkte passen wie angegeben auf { NUM($before_m, digits: 2) } m zu den Aufnahmen, in Metern auf { NUM($after_m, digits: 2) } m.
    .do = Die Höhen in Metern angeben (Fuß mal 0,3048).

control_unit-point = Punkt { $point } ist wohl in { $millimetres ->
     [yes] Millimetern, die anderen in Metern
     *[no] Metern, die anderen in Millimetern
    }; { $few ->
     [yes] kein Passpunkt geht in die Ausgleichung ein (weniger als { $least } Punkte bleiben)
     *[no] er geht nicht in die Ausgleichung ein
    }.
    .why = Er liegt { NUM($before_m, digits: 2) } m von dem Ort, den die anderen ergeben, mit dem Faktor { $factor } { NUM($after_m, digits: 2) } m.
    .do = Alle Koordinaten in einer Einheit angeben.
