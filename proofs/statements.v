(******************************************************************************)
(* What the main theorems state, printed by Coq: all of theorems.v, and those *)
(* that the ledger's first tables name. statements.out holds what must be     *)
(* printed, so a statement cannot change without its change being seen there. *)
(* check_sources.sh compares it, and writes both files anew with --write.     *)
(******************************************************************************)
From Cleave Require connectivity.
From Cleave Require complex.
From Cleave Require isomorphism.
From Cleave Require relabelling.
From Cleave Require copies.
From Cleave Require opening.
From Cleave Require splits.
From Cleave Require universal.
From Cleave Require stages.
From Cleave Require pieces.
From Cleave Require unglue.
From Cleave Require incision.
From Cleave Require history.
From Cleave Require canonical.
From Cleave Require orientation.
From Cleave Require canonical_complex.
From Cleave Require algorithm5.
From Cleave Require boundary.
From Cleave Require chain.
From Cleave Require oriented_boundary.
From Cleave Require algorithm3.
From Cleave Require certify.
From Cleave Require listed_complex.
From Cleave Require tries.
From Cleave Require quick_find.
From Cleave Require half_facets.
From Cleave Require listed.
From Cleave Require prepare.
From Cleave Require denote.
From Cleave Require valid.
From Cleave Require certify_exec.
From Cleave Require unglue_exec.
From Cleave Require regular_exec.
From Cleave Require examples.
From Cleave Require fem.
From Cleave Require elasticity.
From Cleave Require equation1.
From Cleave Require rigid_motion.
From Cleave Require elastic_kernel.
From Cleave Require supports.
From Cleave Require stiffness_matrix.
From Cleave Require kernel_dimension.
From Cleave Require lemma1.
From Cleave Require crossing_point.
From Cleave Require nearest_vertex.
From Cleave Require parity.
From Cleave Require dual_edge.
From Cleave Require ridge_loop.
From Cleave Require star_opening.
From Cleave Require simply_connected.
From Cleave Require torus.
From Cleave Require hole.
From Cleave Require theorems.
From Cleave Require split_star.
From Cleave Require culprits.
From Cleave Require unit_body.
From mathcomp Require Import all_ssreflect all_algebra fingroup perm.
Set Printing Width 100.
Check theorems.cells_have_vertices.
Check theorems.cells_differ.
Check theorems.facet_is.
Check theorems.mates_are.
Check theorems.boundary_is.
Check theorems.pseudo_manifold_is.
Check theorems.adjacent_is.
Check theorems.glue_is.
Check theorems.cut_regular_is.
Check theorems.unglue_is.
Check theorems.copies_are.
Check theorems.parents_are.
Check theorems.isomorphic_is.
Check theorems.order_is.
Check theorems.half_facet_is.
Check theorems.osame_is.
Check theorems.mate_is.
Check theorems.coherent_is.
Check theorems.neighbour_is.
Check theorems.flood_step_is.
Check theorems.loop_starts.
Check theorems.loop_step.
Check theorems.component_is.
Check theorems.state_is.
Check theorems.originals_are.
Check theorems.now_is.
Check theorems.start_is.
Check theorems.shut_is.
Check theorems.cut_is.
Check theorems.stitch_is.
Check theorems.stays_are.
Check theorems.across_is.
Check theorems.row_is.
Check theorems.run_is.
Check theorems.T1.
Check theorems.T2.
Check theorems.T2_oriented.
Check theorems.T3.
Check theorems.T4.
Check theorems.T5.
Check theorems.T6.
Check theorems.T7.
Check theorems.T8.
Check theorems.T8_stages.
Check theorems.T9.
Check theorems.T10.
Check theorems.T11.
Check theorems.T12.
Check theorems.T12_stitched.
Check theorems.T12_written.
Check theorems.T13.
Check theorems.certify.
Check theorems.two_sides.
Check theorems.T10_signed.
Check theorems.nats_are.
Check theorems.fits_is.
Check theorems.long_is.
Check theorems.wf_is.
Check theorems.ecomplex_is.
Check theorems.ecut_is.
Check theorems.is_facet_is.
Check theorems.vertex_after_is.
Check theorems.checker.
Check algorithm3.T11_all.
Check algorithm3.T11_local.
Check algorithm3.T11_order.
Check algorithm3.T11_regularize.
Check algorithm5.T13_algorithm5.
Check algorithm5.T13_cut_regular.
Check algorithm5.T13_flood.
Check algorithm5.T13_flood_step.
Check algorithm5.flood_step_glue.
Check boundary.T10_mod2.
Check boundary.T10_unglue.
Check canonical.T12_canonical_first.
Check canonical.T12_canonical_injective.
Check canonical.T12_canonical_order.
Check canonical.T12_canonical_partition.
Check canonical.T12_canonical_whole.
Check canonical.T12_handles.
Check canonical.T12_handles_undo.
Check canonical_complex.T12_canonical.
Check canonical_complex.T12_canonical_count.
Check canonical_complex.T12_canonical_isomorphic.
Check canonical_complex.T12_rows.
Check certify.certified_isomorphic.
Check certify.certify_sound_complete.
Check certify_exec.certify_exec_correct.
Check certify_exec.certify_exec_isomorphic.
Check certify_exec.certify_exec_means.
Check copies.T1_bij.
Check copies.T1_card.
Check copies.T1_inj.
Check copies.T1_proj.
Check copies.T2_half_facets.
Check copies.T2_pseudo_manifold.
Check dual_edge.theoremB_degree.
Check dual_edge.theoremB_even.
Check dual_edge.theoremB_full_crossing.
Check dual_edge.theoremB_labelling.
Check dual_edge.theoremB_loop.
Check dual_edge.theoremB_no_rim.
Check dual_edge.theoremB_separates.
Check dual_edge.theoremB_sum.
Check elastic_kernel.T9_kernel.
Check elastic_kernel.T9_kernel_energy.
Check elastic_kernel.T9_kernel_free.
Check elastic_kernel.T9_kernel_unglue.
Check elastic_kernel.T9_kernel_unique.
Check elastic_kernel.T9_piece_disjoint.
Check elastic_kernel.T9_stiffness_energy.
Check elastic_kernel.T9_total_energy_ge0.
Check examples.T8_counterexample.
Check examples.T8_counterexample_3d.
Check fem.T9_block.
Check fem.T9_block_unglue.
Check fem.T9_hinge.
Check history.T12_history.
Check history.T12_history_redo.
Check history.T12_history_start.
Check history.T12_history_undo.
Check hole.annulus_not_simply_connected.
Check hole.theoremB_counterexample.
Check incision.T12_alone.
Check incision.T12_back.
Check incision.T12_mates.
Check incision.T12_order.
Check incision.T12_regular.
Check incision.T12_state.
Check incision.T12_stitch.
Check incision.T12_undo.
Check kernel_dimension.T9_kernel_dim.
Check kernel_dimension.T9_kernel_dim_unglue.
Check nearest_vertex.theoremA.
Check nearest_vertex.theoremA_by_id.
Check nearest_vertex.theoremA_cell.
Check nearest_vertex.theoremA_parity.
Check nearest_vertex.theoremA_plane.
Check nearest_vertex.theoremA_plane_separates.
Check nearest_vertex.theoremA_separates.
Check nearest_vertex.ties_counterexample.
Check opening.T3_adjacent.
Check opening.T3_boundary.
Check opening.T3_mates.
Check opening.T3_old.
Check opening.T3_old_boundary.
Check opening.T3_only.
Check opening.T3_opens.
Check opening.T4_cut_regular.
Check opening.T4_lifted.
Check orientation.T2_coherent.
Check orientation.T2_oriented_facets.
Check oriented_boundary.T10_boundary_chain.
Check oriented_boundary.T10_oriented.
Check oriented_boundary.T10_oriented_unglue.
Check pieces.T9_count.
Check pieces.T9_fem.
Check pieces.T9_pieces.
Check pieces.T9_vertex.
Check ridge_loop.loop_exists.
Check ridge_loop.theoremB_loop_exists.
Check simply_connected.theoremB_even_simply_connected.
Check simply_connected.theoremB_rim_simply_connected.
Check simply_connected.theoremB_simply_connected.
Check splits.T5_converse.
Check splits.T5_empty_cut.
Check splits.T5_idempotent.
Check splits.T5_iff.
Check splits.T5_regular.
Check splits.T6_components.
Check splits.T6_count.
Check splits.T6_local.
Check splits.T6_new.
Check stages.T8_adjacent.
Check stages.T8_forgets.
Check stages.T8_mono.
Check stages.T8_remembered.
Check stages.T8_sequential.
Check stages.T8_staged.
Check star_opening.simply_connected_triangles.
Check star_opening.theoremC.
Check star_opening.theoremC_boundary.
Check star_opening.theoremC_even.
Check star_opening.theoremC_front.
Check star_opening.theoremC_full.
Check star_opening.theoremC_path.
Check star_opening.theoremC_ridge.
Check star_opening.theoremC_triangles.
Check star_opening.theoremC_walks.
Check stiffness_matrix.T9_elastic_block.
Check torus.theoremC_counterexample.
Check torus.torus_not_simply_connected.
Check unglue_exec.unglue_exec_correct.
Check unglue_exec.unglue_exec_least.
Check universal.T7_admissible.
Check universal.T7_shut.
Check universal.T7_unique.
Check universal.T7_universal.
Check valid.prepare_complete.
Check culprits.certify_exec_blames.
Check split_star.simply_connected_split.
Check split_star.theoremC_split.
Check unit_body.T9_unit_kernel.
