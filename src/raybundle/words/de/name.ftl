name-unprintable = { $name } ist kein druckbarer Name.
    .do = Den Namen ändern.
