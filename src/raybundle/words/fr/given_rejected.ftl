given_rejected = { $n } observations image rejetées lors d'une compensation antérieure ne participent pas.
