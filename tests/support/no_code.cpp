// Source of targets that only have precompiled headers.
