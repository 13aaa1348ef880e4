epochs_names = { $moved } des { $n } points communs de { $epochs } ont bougé, plus de la moitié.
