accuracy_class-no_unit = { OPTION("accuracy_class") }: Die Klasse { $text } hat keine Einheit.
    .do = Die Einheit der ASPRS-Klasse angeben, z. B. asprs:2.5cm,5cm.

accuracy_class-not_readable = { OPTION("accuracy_class") }: { $text } ist keine Genauigkeit.
    .do = Den RMSE in Metern angeben: 0.03 oder 0.03,0.05 (Lage, Höhe) oder -,0.05 (nur Höhe) oder asprs:2.5cm,5cm.
