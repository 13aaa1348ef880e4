nerfstudio-mixed_models = Der Block hat Fischaugen- und Flächenkameras; transforms.json kennt nur ein Kameramodell.
    .do = Die Kameras getrennt ausgeben.

nerfstudio-model_contradiction = Der Schalter widerspricht camera_model { $model }.
    .do = Eine der Angaben korrigieren.

nerfstudio-field_of_view = Ein Bildwinkel von { $angle_deg }° hat keine Brennweite.
    .do = Einen Winkel zwischen 0° und 180° angeben.

nerfstudio-focal_length_missing = Die Brennweite fehlt.
    .do = fl_x [px] oder camera_angle_x [rad] angeben, in der Datei oder je Bild.

nerfstudio-parameter_unused = Der Wert { $value } ist angegeben, aber { $model } hat keinen solchen Parameter.
    .do = Den Wert entfernen oder camera_model korrigieren.
