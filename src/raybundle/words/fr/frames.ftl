frames-too_few_points = { $first } et { $second } : { $n } points communs ; il en faut { $least }.

frames-covariance_singular = { $first } et { $second } : la matrice de covariance commune est singulière.
