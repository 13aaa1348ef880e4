residual_structure = Les résidus de points image voisins sont corrélés ({ NUM($correlation, decimals: 2) }, surtout dans { $ids }).

residual_structure-shared = Les points image ont des erreurs communes ; les écarts-types sont jusqu'à { NUM($largest, digits: 2) } fois trop petits.

residual_structure-fields = Erreurs lisses, différentes d'une image à l'autre : { NUM($tau_px, digits: 2) } px

residual_structure-focus = Mise au point variable : { NUM($focus_px, digits: 2) } px

residual_structure-neighbours = Erreurs communes aux points voisins : { NUM($phi, digits: 2) } fois la variance

residual_structure-times = { $object ->
        [interior] Orientation interne
       *[points] Points objet
     } : écarts-types { NUM($factor, digits: 2) } fois trop petits (médiane)

residual_structure-sample = Ces valeurs sont estimées sur une partie du bloc : { $images } images compensées séparément.

residual_structure-with_fields = Avec des champs de bruit ({ OPTION("noise", "fields") }, comme dans `orient`), les écarts-types contiennent ces erreurs.
