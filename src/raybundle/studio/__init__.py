"""The studio: measuring, looking and deciding in a browser.

    guard     who may ask: one session by a token that works once, this origin, nothing larger than it must be
    tiles     photographs as tiles of reduced copies, made when they are looked at
    desk      what is open: block, adjustment, journal, photographs
    answers   what is reported of it, as plain data
    verbs     each action as the command that does the same
    live      who watches, and what they are reported
    work      adjusting in the background
    app       the routes
    serve     the server itself

The page is made of `web/studio`, its built files are in `static`.
"""
