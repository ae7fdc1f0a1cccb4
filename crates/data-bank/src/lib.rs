//! Data banks: drums that turn, their queues, and the storage buffer in front of them (hardware section 2.3).
