bias-point_count = { $ground } points terrain et { $image } points image sont donnés.

bias-misfit = Les points d'appui ne concordent pas avec le RPC et le biais { $model } : rms { $x_px } px en x, { $y_px } px en y.

bias-not_determined = { $n } points ne déterminent pas la correction { $model }.

bias-points_excluded = { $n } points exclus sur { $total }

bias-improvement = Le biais { $model } améliore nettement l'ajustement : { $test } { $value } dépasse { $limit }.

bias-rpc_contradicted = none : { $larger ->
        [yes] aucun modèle plus grand ne convient mieux
       *[no] aucun modèle plus grand n'est possible
     }, mais les points contredisent les RPC.

bias-rpc_confirmed = none : les RPC concordent avec les points dans leur sigma de { $sigma_px } px.
