snooping_robust = { $rejected } observations image ont été rejetées après une estimation robuste.
