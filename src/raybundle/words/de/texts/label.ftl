label-rows_shown = { $n } von { $of } Zeilen sind gezeigt.

label-rows_shown_of = { $n } von { $of } Zeilen sind gezeigt; alle stehen in { $rest }.

label-quantity = Größe

label-value = Wert

label-camera = Kamera

label-symbol = Symbol

label-unit = Einheit

label-sigma = σ

label-ratio = Verhältnis
