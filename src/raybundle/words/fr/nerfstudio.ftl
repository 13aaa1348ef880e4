nerfstudio-mixed_models = Le bloc a des fisheyes et des caméras à cadre ; transforms.json n'admet qu'un modèle.

nerfstudio-model_contradiction = L'indicateur contredit camera_model { $model }.

nerfstudio-field_of_view = Un champ de { $angle_deg }° n'a pas de distance focale.

nerfstudio-focal_length_missing = La distance focale manque.

nerfstudio-parameter_unused = La valeur { $value } est donnée, mais { $model } n'a pas ce paramètre.
