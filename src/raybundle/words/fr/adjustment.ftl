adjustment-corrected_residuals = Caméra { $camera } : les résidus corrigés n'existent que pour le modèle brown, pas pour { $model }.

adjustment-no_point = Aucun point objet ne participe à la compensation.

adjustment-options_type = Les options sont du type { $type }, pas AdjustmentOptions.

adjustment-block_type = Le bloc est du type { $type }, pas Block.

adjustment-option_choice = L'option { $name } vaut { $given }.

adjustment-option_not_bool = L'option { $name } vaut { $given } ; il faut True ou False.

adjustment-option_not_names = L'option { $name } vaut { $given } ; il faut un tuple de { $pairs ->
        [yes] paires de noms
       *[no] noms
     }.

adjustment-option_range = L'option { $name } vaut { $given } ; il faut un nombre de { $low } à { $high }.

adjustment-no_statistics = Ce résultat n'a pas d'équations normales.

adjustment-groups_without_statistics = Les facteurs de variance par groupe demandent les nombres de redondance.

adjustment-all_rejected = Bloc { $block } : les { $n } observations image sont toutes rejetées.

adjustment-no_observation = Le bloc { $block } n'a pas d'observations image.

adjustment-too_few_observations = { $n } observations ne déterminent pas { $unknowns } inconnues ; il en manque { $missing }.

adjustment-image_points_contradict = Les points image se contredisent de { PERCENT($share) } % de la diagonale (limite { PERCENT($limit) } %).

adjustment-not_finite = Pas de convergence : après { $iterations } itérations les équations normales ne sont pas finies.

adjustment-no_convergence = Pas de convergence après { $iterations } itérations (dernier pas { NUM($step_sigmas, digits: 2) } écarts-types).

adjustment-identical_images = Pas de convergence : { $pairs } paires d'images ont les mêmes points image à un demi-pixel près.

adjustment-out_missing = Le dossier du résultat manque : ce n'est pas un projet.
