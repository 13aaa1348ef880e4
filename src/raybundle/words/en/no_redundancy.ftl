no_redundancy = The adjustment has no redundancy.
    .why = sigma0 cannot be estimated, and no blunder can be found; standard deviations carry the a-priori sigma0.
    .do = Add observations.
