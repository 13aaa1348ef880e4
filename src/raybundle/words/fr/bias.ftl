bias-unknown_model = Le modèle de biais { $name } est inconnu.

bias-point_count = { $ground } points terrain et { $image } points image sont donnés.

bias-misfit = Les points d'appui ne concordent pas avec le RPC et le biais { $model } : rms { $x_px } px en x, { $y_px } px en y.

bias-not_determined = { $n } points ne déterminent pas la correction { $model }.
