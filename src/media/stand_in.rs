//! Stand-ins for the site's media.
