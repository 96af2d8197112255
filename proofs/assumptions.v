(******************************************************************************)
(* What the theorems rest on. For each of them Coq prints its name and then   *)
(* the axioms that its proof uses: Closed under the global context, that is   *)
(* none. assumptions.out holds what must be printed; check_sources.sh         *)
(* compares, and writes both files anew with --write.                         *)
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
From Cleave Require culprits.
From Cleave Require unglue_exec.
From Cleave Require regular_exec.
From Cleave Require examples.
From Cleave Require fem.
From Cleave Require elasticity.
From Cleave Require equation1.
From Cleave Require rigid_motion.
From Cleave Require elastic_kernel.
From Cleave Require unit_body.
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
From Cleave Require split_star.
From Cleave Require theorems.
Locate copies.T1_card.
Print Assumptions copies.T1_card.
Locate copies.T1_inj.
Print Assumptions copies.T1_inj.
Locate copies.T1_proj.
Print Assumptions copies.T1_proj.
Locate copies.T1_bij.
Print Assumptions copies.T1_bij.
Locate copies.T2_pseudo_manifold.
Print Assumptions copies.T2_pseudo_manifold.
Locate copies.T2_half_facets.
Print Assumptions copies.T2_half_facets.
Locate opening.T3_adjacent.
Print Assumptions opening.T3_adjacent.
Locate opening.T3_opens.
Print Assumptions opening.T3_opens.
Locate opening.T3_mates.
Print Assumptions opening.T3_mates.
Locate opening.T3_boundary.
Print Assumptions opening.T3_boundary.
Locate opening.T3_only.
Print Assumptions opening.T3_only.
Locate opening.T3_old.
Print Assumptions opening.T3_old.
Locate opening.T3_old_boundary.
Print Assumptions opening.T3_old_boundary.
Locate opening.T4_lifted.
Print Assumptions opening.T4_lifted.
Locate opening.T4_cut_regular.
Print Assumptions opening.T4_cut_regular.
Locate splits.T6_local.
Print Assumptions splits.T6_local.
Locate splits.T6_components.
Print Assumptions splits.T6_components.
Locate splits.T6_count.
Print Assumptions splits.T6_count.
Locate splits.T6_new.
Print Assumptions splits.T6_new.
Locate splits.T5_regular.
Print Assumptions splits.T5_regular.
Locate splits.T5_empty_cut.
Print Assumptions splits.T5_empty_cut.
Locate splits.T5_converse.
Print Assumptions splits.T5_converse.
Locate splits.T5_iff.
Print Assumptions splits.T5_iff.
Locate splits.T5_idempotent.
Print Assumptions splits.T5_idempotent.
Locate universal.T7_universal.
Print Assumptions universal.T7_universal.
Locate universal.T7_shut.
Print Assumptions universal.T7_shut.
Locate universal.T7_admissible.
Print Assumptions universal.T7_admissible.
Locate universal.T7_unique.
Print Assumptions universal.T7_unique.
Locate stages.T8_mono.
Print Assumptions stages.T8_mono.
Locate stages.T8_adjacent.
Print Assumptions stages.T8_adjacent.
Locate stages.T8_staged.
Print Assumptions stages.T8_staged.
Locate stages.T8_sequential.
Print Assumptions stages.T8_sequential.
Locate stages.T8_remembered.
Print Assumptions stages.T8_remembered.
Locate stages.T8_forgets.
Print Assumptions stages.T8_forgets.
Locate pieces.T9_pieces.
Print Assumptions pieces.T9_pieces.
Locate pieces.T9_count.
Print Assumptions pieces.T9_count.
Locate pieces.T9_vertex.
Print Assumptions pieces.T9_vertex.
Locate pieces.T9_fem.
Print Assumptions pieces.T9_fem.
Locate incision.T12_mates.
Print Assumptions incision.T12_mates.
Locate incision.T12_stitch.
Print Assumptions incision.T12_stitch.
Locate incision.T12_state.
Print Assumptions incision.T12_state.
Locate incision.T12_alone.
Print Assumptions incision.T12_alone.
Locate incision.T12_back.
Print Assumptions incision.T12_back.
Locate incision.T12_order.
Print Assumptions incision.T12_order.
Locate incision.T12_undo.
Print Assumptions incision.T12_undo.
Locate incision.T12_regular.
Print Assumptions incision.T12_regular.
Locate history.T12_history.
Print Assumptions history.T12_history.
Locate history.T12_history_undo.
Print Assumptions history.T12_history_undo.
Locate history.T12_history_redo.
Print Assumptions history.T12_history_redo.
Locate history.T12_history_start.
Print Assumptions history.T12_history_start.
Locate canonical.T12_canonical_injective.
Print Assumptions canonical.T12_canonical_injective.
Locate canonical.T12_canonical_whole.
Print Assumptions canonical.T12_canonical_whole.
Locate canonical.T12_canonical_first.
Print Assumptions canonical.T12_canonical_first.
Locate canonical.T12_canonical_range.
Print Assumptions canonical.T12_canonical_range.
Locate canonical.T12_canonical_order.
Print Assumptions canonical.T12_canonical_order.
Locate canonical.T12_canonical_partition.
Print Assumptions canonical.T12_canonical_partition.
Locate canonical.T12_handles.
Print Assumptions canonical.T12_handles.
Locate canonical.T12_handles_undo.
Print Assumptions canonical.T12_handles_undo.
Locate orientation.coherent_each_in_one_cell.
Print Assumptions orientation.coherent_each_in_one_cell.
Locate orientation.coherent_pseudo_manifold.
Print Assumptions orientation.coherent_pseudo_manifold.
Locate orientation.T2_coherent.
Print Assumptions orientation.T2_coherent.
Locate orientation.T2_oriented_facets.
Print Assumptions orientation.T2_oriented_facets.
Locate canonical_complex.T12_canonical_isomorphic.
Print Assumptions canonical_complex.T12_canonical_isomorphic.
Locate canonical_complex.T12_canonical_count.
Print Assumptions canonical_complex.T12_canonical_count.
Locate canonical_complex.T12_canonical.
Print Assumptions canonical_complex.T12_canonical.
Locate canonical_complex.T12_rows.
Print Assumptions canonical_complex.T12_rows.
Locate algorithm5.T13_flood.
Print Assumptions algorithm5.T13_flood.
Locate algorithm5.T13_cut_regular.
Print Assumptions algorithm5.T13_cut_regular.
Locate algorithm5.T13_algorithm5.
Print Assumptions algorithm5.T13_algorithm5.
Locate algorithm5.T13_neighbour.
Print Assumptions algorithm5.T13_neighbour.
Locate algorithm5.T13_flood_step.
Print Assumptions algorithm5.T13_flood_step.
Locate boundary.T10_mod2.
Print Assumptions boundary.T10_mod2.
Locate boundary.T10_unglue.
Print Assumptions boundary.T10_unglue.
Locate oriented_boundary.T10_boundary_chain.
Print Assumptions oriented_boundary.T10_boundary_chain.
Locate oriented_boundary.T10_oriented.
Print Assumptions oriented_boundary.T10_oriented.
Locate oriented_boundary.T10_oriented_unglue.
Print Assumptions oriented_boundary.T10_oriented_unglue.
Locate algorithm3.T11_order.
Print Assumptions algorithm3.T11_order.
Locate algorithm3.T11_all.
Print Assumptions algorithm3.T11_all.
Locate algorithm3.T11_local.
Print Assumptions algorithm3.T11_local.
Locate algorithm3.T11_regularize.
Print Assumptions algorithm3.T11_regularize.
Locate certify.certify_sound_complete.
Print Assumptions certify.certify_sound_complete.
Locate certify.certified_isomorphic.
Print Assumptions certify.certified_isomorphic.
Locate quick_find.classesP.
Print Assumptions quick_find.classesP.
Locate half_facets.mate_good.
Print Assumptions half_facets.mate_good.
Locate half_facets.matesP.
Print Assumptions half_facets.matesP.
Locate denote.eqv_glue.
Print Assumptions denote.eqv_glue.
Locate denote.name_copy.
Print Assumptions denote.name_copy.
Locate valid.prepare_complete.
Print Assumptions valid.prepare_complete.
Locate valid.prepare_edges.
Print Assumptions valid.prepare_edges.
Locate certify_exec.certify_exec_means.
Print Assumptions certify_exec.certify_exec_means.
Locate certify_exec.certify_exec_correct.
Print Assumptions certify_exec.certify_exec_correct.
Locate certify_exec.certify_exec_isomorphic.
Print Assumptions certify_exec.certify_exec_isomorphic.
Locate culprits.prepare_blames.
Print Assumptions culprits.prepare_blames.
Locate culprits.certify_exec_blames.
Print Assumptions culprits.certify_exec_blames.
Locate unglue_exec.unglue_exec_correct.
Print Assumptions unglue_exec.unglue_exec_correct.
Locate unglue_exec.unglue_exec_least.
Print Assumptions unglue_exec.unglue_exec_least.
Locate regular_exec.regularP.
Print Assumptions regular_exec.regularP.
Locate examples.fig8_split.
Print Assumptions examples.fig8_split.
Locate examples.fig7_unchanged.
Print Assumptions examples.fig7_unchanged.
Locate examples.T8_counterexample.
Print Assumptions examples.T8_counterexample.
Locate examples.T8_counterexample_3d.
Print Assumptions examples.T8_counterexample_3d.
Locate fem.T9_sparse.
Print Assumptions fem.T9_sparse.
Locate fem.T9_block.
Print Assumptions fem.T9_block.
Locate fem.T9_translations.
Print Assumptions fem.T9_translations.
Locate fem.T9_hinge.
Print Assumptions fem.T9_hinge.
Locate elasticity.T9_strain_eq0.
Print Assumptions elasticity.T9_strain_eq0.
Locate elasticity.T9_energy_ge0.
Print Assumptions elasticity.T9_energy_ge0.
Locate elasticity.T9_energy_eq0.
Print Assumptions elasticity.T9_energy_eq0.
Locate elasticity.T9_elastic_exact.
Print Assumptions elasticity.T9_elastic_exact.
Locate elasticity.T9_work.
Print Assumptions elasticity.T9_work.
Locate elasticity.T9_work_symmetric.
Print Assumptions elasticity.T9_work_symmetric.
Locate elasticity.T9_work_self.
Print Assumptions elasticity.T9_work_self.
Locate elasticity.T9_forces_eq0.
Print Assumptions elasticity.T9_forces_eq0.
Locate equation1.equation1_printed_rotation.
Print Assumptions equation1.equation1_printed_rotation.
Locate equation1.equation1_mended_rotation.
Print Assumptions equation1.equation1_mended_rotation.
Locate equation1.equation1_mended_symmetric.
Print Assumptions equation1.equation1_mended_symmetric.
Locate equation1.equation1_printed_symmetric.
Print Assumptions equation1.equation1_printed_symmetric.
Locate equation1.equation1_printed_shear.
Print Assumptions equation1.equation1_printed_shear.
Locate equation1.equation1_left_strain.
Print Assumptions equation1.equation1_left_strain.
Locate equation1.equation1_right_gradient.
Print Assumptions equation1.equation1_right_gradient.
Locate equation1.equation1_right_gradient_symmetric.
Print Assumptions equation1.equation1_right_gradient_symmetric.
Locate rigid_motion.nondegenerateP.
Print Assumptions rigid_motion.nondegenerateP.
Locate rigid_motion.T9_rigid_on_cell.
Print Assumptions rigid_motion.T9_rigid_on_cell.
Locate rigid_motion.T9_rigid_unique.
Print Assumptions rigid_motion.T9_rigid_unique.
Locate rigid_motion.T9_facet_held.
Print Assumptions rigid_motion.T9_facet_held.
Locate rigid_motion.T9_shared_facet.
Print Assumptions rigid_motion.T9_shared_facet.
Locate elastic_kernel.T9_simplex_volume_gt0.
Print Assumptions elastic_kernel.T9_simplex_volume_gt0.
Locate elastic_kernel.T9_piece_disjoint.
Print Assumptions elastic_kernel.T9_piece_disjoint.
Locate elastic_kernel.T9_stiffness_symmetric.
Print Assumptions elastic_kernel.T9_stiffness_symmetric.
Locate elastic_kernel.T9_stiffness_energy.
Print Assumptions elastic_kernel.T9_stiffness_energy.
Locate elastic_kernel.T9_total_energy_ge0.
Print Assumptions elastic_kernel.T9_total_energy_ge0.
Locate elastic_kernel.T9_kernel_energy.
Print Assumptions elastic_kernel.T9_kernel_energy.
Locate elastic_kernel.T9_kernel.
Print Assumptions elastic_kernel.T9_kernel.
Locate elastic_kernel.T9_kernel_unique.
Print Assumptions elastic_kernel.T9_kernel_unique.
Locate elastic_kernel.T9_kernel_free.
Print Assumptions elastic_kernel.T9_kernel_free.
Locate elastic_kernel.T9_supported.
Print Assumptions elastic_kernel.T9_supported.
Locate elastic_kernel.T9_kernel_unglue.
Print Assumptions elastic_kernel.T9_kernel_unglue.
Locate unit_body.T9_unit_volume.
Print Assumptions unit_body.T9_unit_volume.
Locate unit_body.T9_unit_kernel.
Print Assumptions unit_body.T9_unit_kernel.
Locate supports.T9_facet_supports.
Print Assumptions supports.T9_facet_supports.
Locate supports.T9_axis_free.
Print Assumptions supports.T9_axis_free.
Locate supports.T9_vertex_free.
Print Assumptions supports.T9_vertex_free.
Locate stiffness_matrix.T9_stiffness_matrix.
Print Assumptions stiffness_matrix.T9_stiffness_matrix.
Locate stiffness_matrix.T9_element_symmetric.
Print Assumptions stiffness_matrix.T9_element_symmetric.
Locate stiffness_matrix.T9_elastic_block.
Print Assumptions stiffness_matrix.T9_elastic_block.
Locate kernel_dimension.T9_dim_skews.
Print Assumptions kernel_dimension.T9_dim_skews.
Locate kernel_dimension.T9_kernel_dim.
Print Assumptions kernel_dimension.T9_kernel_dim.
Locate kernel_dimension.T9_kernel_dim_unglue.
Print Assumptions kernel_dimension.T9_kernel_dim_unglue.
Locate lemma1.lemma1_mended.
Print Assumptions lemma1.lemma1_mended.
Locate lemma1.lemma1_exact.
Print Assumptions lemma1.lemma1_exact.
Locate lemma1.lemma1_facet.
Print Assumptions lemma1.lemma1_facet.
Locate lemma1.tiebreak_bound.
Print Assumptions lemma1.tiebreak_bound.
Locate lemma1.cex_22.
Print Assumptions lemma1.cex_22.
Locate lemma1.cex_13.
Print Assumptions lemma1.cex_13.
Locate crossing_point.closest_end.
Print Assumptions crossing_point.closest_end.
Locate crossing_point.picks_plane.
Print Assumptions crossing_point.picks_plane.
Locate crossing_point.closest_plane.
Print Assumptions crossing_point.closest_plane.
Locate crossing_point.lemma1_triangle.
Print Assumptions crossing_point.lemma1_triangle.
Locate nearest_vertex.theoremA_cell.
Print Assumptions nearest_vertex.theoremA_cell.
Locate nearest_vertex.theoremA.
Print Assumptions nearest_vertex.theoremA.
Locate nearest_vertex.theoremA_separates.
Print Assumptions nearest_vertex.theoremA_separates.
Locate nearest_vertex.theoremA_parity.
Print Assumptions nearest_vertex.theoremA_parity.
Locate nearest_vertex.theoremA_by_id.
Print Assumptions nearest_vertex.theoremA_by_id.
Locate nearest_vertex.theoremA_plane.
Print Assumptions nearest_vertex.theoremA_plane.
Locate nearest_vertex.theoremA_plane_separates.
Print Assumptions nearest_vertex.theoremA_plane_separates.
Locate nearest_vertex.ties_counterexample.
Print Assumptions nearest_vertex.ties_counterexample.
Locate parity.labellingP.
Print Assumptions parity.labellingP.
Locate dual_edge.theoremB_separates.
Print Assumptions dual_edge.theoremB_separates.
Locate dual_edge.theoremB_sum.
Print Assumptions dual_edge.theoremB_sum.
Locate dual_edge.theoremB_loop.
Print Assumptions dual_edge.theoremB_loop.
Locate dual_edge.theoremB_degree.
Print Assumptions dual_edge.theoremB_degree.
Locate dual_edge.theoremB_labelling.
Print Assumptions dual_edge.theoremB_labelling.
Locate dual_edge.theoremB_even.
Print Assumptions dual_edge.theoremB_even.
Locate dual_edge.theoremB_no_rim.
Print Assumptions dual_edge.theoremB_no_rim.
Locate ridge_loop.loop_exists.
Print Assumptions ridge_loop.loop_exists.
Locate ridge_loop.theoremB_loop_exists.
Print Assumptions ridge_loop.theoremB_loop_exists.
Locate star_opening.theoremC.
Print Assumptions star_opening.theoremC.
Locate star_opening.theoremC_walks.
Print Assumptions star_opening.theoremC_walks.
Locate star_opening.theoremC_full.
Print Assumptions star_opening.theoremC_full.
Locate star_opening.theoremC_even.
Print Assumptions star_opening.theoremC_even.
Locate star_opening.theoremC_ridge.
Print Assumptions star_opening.theoremC_ridge.
Locate star_opening.theoremC_triangles.
Print Assumptions star_opening.theoremC_triangles.
Locate star_opening.theoremC_path.
Print Assumptions star_opening.theoremC_path.
Locate simply_connected.theoremB_even_simply_connected.
Print Assumptions simply_connected.theoremB_even_simply_connected.
Locate simply_connected.theoremB_simply_connected.
Print Assumptions simply_connected.theoremB_simply_connected.
Locate simply_connected.theoremB_rim_simply_connected.
Print Assumptions simply_connected.theoremB_rim_simply_connected.
Locate torus.theoremC_counterexample.
Print Assumptions torus.theoremC_counterexample.
Locate hole.theoremB_counterexample.
Print Assumptions hole.theoremB_counterexample.
Locate split_star.simply_connected_split.
Print Assumptions split_star.simply_connected_split.
Locate theorems.T1.
Print Assumptions theorems.T1.
Locate theorems.T2.
Print Assumptions theorems.T2.
Locate theorems.T2_oriented.
Print Assumptions theorems.T2_oriented.
Locate theorems.T3.
Print Assumptions theorems.T3.
Locate theorems.T4.
Print Assumptions theorems.T4.
Locate theorems.T5.
Print Assumptions theorems.T5.
Locate theorems.T6.
Print Assumptions theorems.T6.
Locate theorems.T7.
Print Assumptions theorems.T7.
Locate theorems.T8.
Print Assumptions theorems.T8.
Locate theorems.T8_stages.
Print Assumptions theorems.T8_stages.
Locate theorems.T9.
Print Assumptions theorems.T9.
Locate theorems.T10.
Print Assumptions theorems.T10.
Locate theorems.T11.
Print Assumptions theorems.T11.
Locate theorems.T12.
Print Assumptions theorems.T12.
Locate theorems.T12_stitched.
Print Assumptions theorems.T12_stitched.
Locate theorems.T12_written.
Print Assumptions theorems.T12_written.
Locate theorems.T13.
Print Assumptions theorems.T13.
Locate theorems.certify.
Print Assumptions theorems.certify.
Locate theorems.two_sides.
Print Assumptions theorems.two_sides.
Locate theorems.T10_signed.
Print Assumptions theorems.T10_signed.
Locate theorems.checker.
Print Assumptions theorems.checker.
Locate algorithm3.algorithm3_unglue.
Print Assumptions algorithm3.algorithm3_unglue.
Locate algorithm5.flood_step_glue.
Print Assumptions algorithm5.flood_step_glue.
Locate copies.copy_eq.
Print Assumptions copies.copy_eq.
Locate crossing_point.lemma1_triangle_bound.
Print Assumptions crossing_point.lemma1_triangle_bound.
Locate dual_edge.theoremB_full_crossing.
Print Assumptions dual_edge.theoremB_full_crossing.
Locate equation1.equation1_printed_asymmetric.
Print Assumptions equation1.equation1_printed_asymmetric.
Locate equation1.equation1_printed_unit.
Print Assumptions equation1.equation1_printed_unit.
Locate equation1.equation1_sheared_tetrahedron.
Print Assumptions equation1.equation1_sheared_tetrahedron.
Locate examples.T8_seq_noop.
Print Assumptions examples.T8_seq_noop.
Locate examples.T8_union_splits.
Print Assumptions examples.T8_union_splits.
Locate examples.fig7_3d.
Print Assumptions examples.fig7_3d.
Locate examples.fig7_is_interior.
Print Assumptions examples.fig7_is_interior.
Locate fem.T9_block_unglue.
Print Assumptions fem.T9_block_unglue.
Locate hole.annulus_not_simply_connected.
Print Assumptions hole.annulus_not_simply_connected.
Locate lemma1.extremes_exist.
Print Assumptions lemma1.extremes_exist.
Locate lemma1.lemma1_bound.
Print Assumptions lemma1.lemma1_bound.
Locate lemma1.lemma1_single.
Print Assumptions lemma1.lemma1_single.
Locate lemma1.tiebreak_bounded.
Print Assumptions lemma1.tiebreak_bounded.
Locate orientation.osame_or_mate.
Print Assumptions orientation.osame_or_mate.
Locate relabelling.relabel_iso.
Print Assumptions relabelling.relabel_iso.
Locate rigid_motion.gradP.
Print Assumptions rigid_motion.gradP.
Locate rigid_motion.grad_uniq.
Print Assumptions rigid_motion.grad_uniq.
Locate split_star.theoremC_split.
Print Assumptions split_star.theoremC_split.
Locate star_opening.simply_connected_triangles.
Print Assumptions star_opening.simply_connected_triangles.
Locate star_opening.theoremC_boundary.
Print Assumptions star_opening.theoremC_boundary.
Locate star_opening.theoremC_front.
Print Assumptions star_opening.theoremC_front.
Locate torus.torus_not_simply_connected.
Print Assumptions torus.torus_not_simply_connected.
