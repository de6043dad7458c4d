struct type_2 {
member: u32,
member_1: u32,
member_2: u32,
}
struct type_4 {
member: f32,
member_1: f32,
member_2: f32,
member_3: u32,
}
struct type_5 {
member: f32,
member_1: f32,
member_2: f32,
}
struct type_6 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: type_5,
member_8: type_5,
member_9: type_5,
member_10: f32,
member_11: f32,
member_12: f32,
}
struct type_7 {
member: type_5,
member_1: f32,
}
struct type_8 {
member: type_7,
member_1: type_5,
}
struct type_9 {
member: type_8,
member_1: type_8,
}
struct type_10 {
member: type_5,
member_1: type_5,
member_2: f32,
member_3: f32,
member_4: u32,
member_5: u32,
member_6: u32,
}
struct type_11 {
member: u32,
member_1: type_5,
member_2: type_5,
member_3: type_5,
member_4: type_10,
}
struct type_12 {
member: type_5,
member_1: type_5,
member_2: type_5,
member_3: type_5,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: type_5,
member_8: type_5,
member_9: type_5,
}
struct type_13 {
member: u32,
member_1: u32,
}
struct type_15 {
member: array<f32>,
}
struct type_19 {
member: vec3<f32>,
member_1: vec3<f32>,
member_2: vec3<f32>,
member_3: vec3<f32>,
member_4: vec3<f32>,
member_5: f32,
member_6: f32,
member_7: i32,
member_8: f32,
member_9: f32,
member_10: f32,
member_11: f32,
member_12: vec3<f32>,
member_13: vec3<f32>,
member_14: i32,
member_15: i32,
member_16: i32,
member_17: f32,
}
struct type_20 {
member: u32,
member_1: type_5,
member_2: type_5,
member_3: type_5,
member_4: type_5,
member_5: f32,
member_6: f32,
member_7: f32,
member_8: f32,
}
struct type_21 {
member: f32,
member_1: f32,
member_2: f32,
member_3: u32,
member_4: u32,
member_5: u32,
member_6: u32,
member_7: u32,
member_8: u32,
member_9: u32,
member_10: u32,
member_11: u32,
member_12: u32,
member_13: u32,
member_14: f32,
member_15: f32,
member_16: f32,
}
struct type_22 {
member: type_5,
member_1: type_5,
member_2: f32,
member_3: u32,
member_4: type_5,
member_5: type_5,
member_6: u32,
member_7: u32,
member_8: u32,
member_9: u32,
member_10: u32,
member_11: u32,
}
struct type_23 {
member: f32,
member_1: u32,
member_2: u32,
member_3: u32,
member_4: u32,
member_5: u32,
member_6: u32,
member_7: u32,
member_8: u32,
member_9: u32,
}
struct type_24 {
member: type_5,
member_1: f32,
member_2: f32,
member_3: u32,
}
struct type_25 {
member: type_2,
member_1: type_13,
member_2: type_4,
member_3: type_5,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: f32,
member_8: type_5,
member_9: type_5,
member_10: type_11,
member_11: type_20,
member_12: type_21,
member_13: type_22,
member_14: type_9,
member_15: type_6,
member_16: type_12,
member_17: u32,
member_18: type_23,
member_19: type_24,
}
struct type_26 {
member: type_25,
}
struct type_27 {
member: vec3<f32>,
member_1: vec3<f32>,
member_2: vec3<f32>,
member_3: vec3<f32>,
member_4: f32,
member_5: bool,
member_6: bool,
}
struct type_28 {
member: i32,
member_1: i32,
member_2: f32,
}
struct type_31 {
member: array<atomic<u32>>,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_26;
@group(0) @binding(1)
var<storage> global_2: type_15;
@group(0) @binding(3)
var<storage> global_3: type_15;
@group(0) @binding(4)
var<storage> global_4: type_15;
@group(0) @binding(6)
var<storage, read_write> global_5: type_15;
@group(0) @binding(2)
var<storage> global_6: type_15;
@group(0) @binding(5)
var<storage> global_7: type_15;
@group(0) @binding(7)
var<storage, read_write> global_8: type_31;
fn function_() {
var local: i32;
var local_1: i32;
var phi_407_: bool;
var phi_497_: u32;
var phi_561_: type_28;
var phi_2238_: type_27;
var phi_2350_: vec3<f32>;
var phi_2404_: type_19;
var phi_2407_: i32;
var phi_2409_: type_28;
var phi_2702_: i32;
var phi_3069_: type_19;
var phi_3070_: type_19;
var phi_3077_: type_28;
var phi_2405_: type_19;
var phi_2408_: i32;
var phi_2410_: type_28;
var local_2: type_28;
var local_3: i32;
var local_4: f32;
let _e72 = global;
let _e90 = global_1.member.member;
if (_e72.x < _e90.member) {
if (_e72.y < _e90.member_1) {
let _e97 = (_e90.member * _e90.member_1);
let _e99 = ((_e72.y * _e90.member) + _e72.x);
let _e100 = bitcast<i32>(_e99);
let _e102 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e104 = select(_e102, _e100, (_e100 < _e102));
let _e110 = global_5.member[bitcast<u32>(select(0i, _e104, (_e104 > 0i)))];
let _e111 = (_e97 + _e99);
let _e112 = bitcast<i32>(_e111);
let _e114 = select(_e102, _e112, (_e112 < _e102));
let _e120 = global_5.member[bitcast<u32>(select(0i, _e114, (_e114 > 0i)))];
let _e122 = ((2u * _e97) + _e99);
let _e123 = bitcast<i32>(_e122);
let _e125 = select(_e102, _e123, (_e123 < _e102));
let _e131 = global_5.member[bitcast<u32>(select(0i, _e125, (_e125 > 0i)))];
let _e138 = select(0i, select(select(i32(_e110), i32(-2147483648), (_e110 < -2147483600f)), 2147483647i, (_e110 > 2147483500f)), (_e110 == _e110));
let _e145 = select(0i, select(select(i32(_e120), i32(-2147483648), (_e120 < -2147483600f)), 2147483647i, (_e120 > 2147483500f)), (_e120 == _e120));
let _e149 = global_1.member.member.member;
let _e153 = global_1.member.member.member_1;
let _e154 = (_e149 * _e153);
let _e155 = bitcast<i32>(_e154);
let _e158 = ((_e72.y * _e149) + _e72.x);
let _e159 = bitcast<i32>(_e158);
let _e160 = ((23i * _e155) + _e159);
let _e162 = (bitcast<i32>(arrayLength((&global_2.member))) - 1i);
let _e164 = select(_e162, _e160, (_e160 < _e162));
let _e170 = global_2.member[bitcast<u32>(select(0i, _e164, (_e164 > 0i)))];
let _e177 = select(0i, select(select(i32(_e170), i32(-2147483648), (_e170 < -2147483600f)), 2147483647i, (_e170 > 2147483500f)), (_e170 == _e170));
let _e181 = global_1.member.member_12.member_4;
let _e183 = (bitcast<i32>(_e181) + 1i);
let _e185 = bitcast<i32>(arrayLength((&global_6.member)));
let _e186 = (_e185 / 8i);
let _e192 = (_e177 >= 0i);
let _e195 = ((select(0i, _e177, _e192) * 19i) + 18i);
let _e197 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e199 = select(_e197, _e195, (_e195 < _e197));
let _e205 = global_3.member[bitcast<u32>(select(0i, _e199, (_e199 > 0i)))];
let _e212 = select(0i, select(select(i32(_e205), i32(-2147483648), (_e205 < -2147483600f)), 2147483647i, (_e205 > 2147483500f)), (_e205 == _e205));
let _e213 = (_e212 * 4i);
let _e215 = (bitcast<i32>(arrayLength((&global_7.member))) - 1i);
let _e217 = select(_e215, _e213, (_e213 < _e215));
let _e223 = global_7.member[bitcast<u32>(select(0i, _e217, (_e217 > 0i)))];
if _e192 {
phi_407_ = (select(_e223, 1f, (_e212 == 16i)) == 0f);
} else {
phi_407_ = (_e177 != -1i);
}
let _e229 = phi_407_;
let _e233 = global_1.member.member_17;
if ((!(((_e138 == _e183) && ((_e145 >= _e186) || (_e131 > 0f)))) && _e229) && ((_e233 & 4u) != 0u)) {
local = _e155;
local_1 = _e159;
let _e237 = local;
let _e239 = local_1;
let _e240 = ((29i * _e237) + _e239);
let _e242 = select(_e162, _e240, (_e240 < _e162));
let _e247 = global_2.member[bitcast<u32>(select(0i, _e242, (_e242 > 0i)))];
let _e249 = local;
let _e251 = local_1;
let _e252 = ((36i * _e249) + _e251);
let _e254 = select(_e162, _e252, (_e252 < _e162));
let _e259 = global_2.member[bitcast<u32>(select(0i, _e254, (_e254 > 0i)))];
phi_497_ = select(0u, 3u, ((_e247 == 2f) && (select(0i, select(select(i32(_e259), i32(-2147483648), (_e259 < -2147483600f)), 2147483647i, (_e259 > 2147483500f)), (_e259 == _e259)) == _e183)));
} else {
phi_497_ = 0u;
}
let _e271 = phi_497_;
if (_e271 > 0u) {
if (arrayLength((&global_8.member)) >= 3u) {
let _e280 = atomicLoad((&global_8.member[0u]));
if (_e280 == 0u) {
atomicStore((&global_8.member[0u]), ((_e90.member + 7u) / 8u));
atomicStore((&global_8.member[1u]), ((_e90.member_1 + 7u) / 8u));
atomicStore((&global_8.member[2u]), 1u);
}
}
}
if (_e271 > 1u) {
if (_e138 != _e183) {
phi_561_ = type_28(_e183, 0i, 0f);
} else {
phi_561_ = type_28(_e138, _e145, _e131);
}
let _e291 = phi_561_;
let _e293 = select(_e162, _e159, (_e159 < _e162));
let _e299 = global_2.member[bitcast<u32>(select(0i, _e293, (_e293 > 0i)))];
let _e301 = bitcast<i32>((_e154 + _e158));
let _e303 = select(_e162, _e301, (_e301 < _e162));
let _e309 = global_2.member[bitcast<u32>(select(0i, _e303, (_e303 > 0i)))];
let _e312 = bitcast<i32>(((2u * _e154) + _e158));
let _e314 = select(_e162, _e312, (_e312 < _e162));
let _e320 = global_2.member[bitcast<u32>(select(0i, _e314, (_e314 > 0i)))];
let _e323 = bitcast<i32>(((3u * _e154) + _e158));
let _e325 = select(_e162, _e323, (_e323 < _e162));
let _e331 = global_2.member[bitcast<u32>(select(0i, _e325, (_e325 > 0i)))];
let _e334 = bitcast<i32>(((4u * _e154) + _e158));
let _e336 = select(_e162, _e334, (_e334 < _e162));
let _e342 = global_2.member[bitcast<u32>(select(0i, _e336, (_e336 > 0i)))];
let _e345 = bitcast<i32>(((5u * _e154) + _e158));
let _e347 = select(_e162, _e345, (_e345 < _e162));
let _e353 = global_2.member[bitcast<u32>(select(0i, _e347, (_e347 > 0i)))];
let _e356 = bitcast<i32>(((23u * _e154) + _e158));
let _e358 = select(_e162, _e356, (_e356 < _e162));
let _e364 = global_2.member[bitcast<u32>(select(0i, _e358, (_e358 > 0i)))];
let _e367 = bitcast<i32>(((24u * _e154) + _e158));
let _e369 = select(_e162, _e367, (_e367 < _e162));
let _e375 = global_2.member[bitcast<u32>(select(0i, _e369, (_e369 > 0i)))];
let _e378 = bitcast<i32>(((30u * _e154) + _e158));
let _e380 = select(_e162, _e378, (_e378 < _e162));
let _e386 = global_2.member[bitcast<u32>(select(0i, _e380, (_e380 > 0i)))];
let _e393 = select(0i, select(select(i32(_e364), i32(-2147483648), (_e364 < -2147483600f)), 2147483647i, (_e364 > 2147483500f)), (_e364 == _e364));
let _e401 = (select(0i, select(select(i32(_e386), i32(-2147483648), (_e386 < -2147483600f)), 2147483647i, (_e386 > 2147483500f)), (_e386 == _e386)) == 0i);
let _e409 = global_1.member.member_1.member;
let _e415 = global_1.member.member_1.member_1;
let _e425 = global_1.member.member_2.member;
let _e426 = (((((f32(bitcast<i32>(_e72.x)) + 0.5f) / f32(bitcast<i32>(_e409))) * 2f) - 1f) * _e425);
let _e434 = global_1.member.member_2.member_1;
let _e435 = ((1f - (((f32(bitcast<i32>(_e72.y)) + 0.5f) / f32(bitcast<i32>(_e415))) * 2f)) * _e434);
let _e438 = global_1.member.member_3;
let _e447 = global_1.member.member_4;
let _e460 = global_1.member.member_2.member_3;
let _e461 = (_e460 != 0u);
let _e464 = global_1.member.member_6;
let _e471 = select(_e464.member, (_e464.member + ((_e438.member * _e426) + (_e447.member * _e435))), _e461);
let _e472 = select(_e464.member_1, (_e464.member_1 + ((_e438.member_1 * _e426) + (_e447.member_1 * _e435))), _e461);
let _e473 = select(_e464.member_2, (_e464.member_2 + ((_e438.member_2 * _e426) + (_e447.member_2 * _e435))), _e461);
let _e488 = select((select(0f, ((((_e299 - _e471) * _e331) + ((_e309 - _e472) * _e342)) + ((_e320 - _e473) * _e353)), _e401) + _e375), 0f, (_e393 == -1i));
let _e492 = (select(_e299, _e471, _e401) + (_e331 * _e488));
let _e493 = (select(_e309, _e472, _e401) + (_e342 * _e488));
let _e494 = (select(_e320, _e473, _e401) + (_e353 * _e488));
let _e495 = vec3<f32>(_e492, _e493, _e494);
if (_e393 >= 0i) {
let _e543 = (_e393 * 19i);
let _e545 = select(_e197, _e543, (_e543 < _e197));
let _e551 = global_3.member[bitcast<u32>(select(0i, _e545, (_e545 > 0i)))];
let _e552 = (_e543 + 1i);
let _e554 = select(_e197, _e552, (_e552 < _e197));
let _e560 = global_3.member[bitcast<u32>(select(0i, _e554, (_e554 > 0i)))];
let _e561 = (_e543 + 2i);
let _e563 = select(_e197, _e561, (_e561 < _e197));
let _e569 = global_3.member[bitcast<u32>(select(0i, _e563, (_e563 > 0i)))];
let _e570 = (_e543 + 3i);
let _e572 = select(_e197, _e570, (_e570 < _e197));
let _e578 = global_3.member[bitcast<u32>(select(0i, _e572, (_e572 > 0i)))];
let _e579 = (_e543 + 4i);
let _e581 = select(_e197, _e579, (_e579 < _e197));
let _e587 = global_3.member[bitcast<u32>(select(0i, _e581, (_e581 > 0i)))];
let _e588 = (_e543 + 5i);
let _e590 = select(_e197, _e588, (_e588 < _e197));
let _e596 = global_3.member[bitcast<u32>(select(0i, _e590, (_e590 > 0i)))];
let _e597 = (_e543 + 6i);
let _e599 = select(_e197, _e597, (_e597 < _e197));
let _e605 = global_3.member[bitcast<u32>(select(0i, _e599, (_e599 > 0i)))];
let _e606 = (_e543 + 7i);
let _e608 = select(_e197, _e606, (_e606 < _e197));
let _e614 = global_3.member[bitcast<u32>(select(0i, _e608, (_e608 > 0i)))];
let _e615 = (_e543 + 8i);
let _e617 = select(_e197, _e615, (_e615 < _e197));
let _e623 = global_3.member[bitcast<u32>(select(0i, _e617, (_e617 > 0i)))];
let _e624 = (_e578 - _e551);
let _e625 = (_e587 - _e560);
let _e626 = (_e596 - _e569);
let _e627 = (_e605 - _e551);
let _e628 = (_e614 - _e560);
let _e629 = (_e623 - _e569);
let _e632 = ((_e625 * _e629) - (_e626 * _e628));
let _e635 = ((_e626 * _e627) - (_e624 * _e629));
let _e638 = ((_e624 * _e628) - (_e625 * _e627));
let _e639 = (_e578 - _e492);
let _e640 = (_e587 - _e493);
let _e641 = (_e596 - _e494);
let _e642 = (_e605 - _e492);
let _e643 = (_e614 - _e493);
let _e644 = (_e623 - _e494);
let _e658 = (((((_e640 * _e644) - (_e641 * _e643)) * _e632) + (((_e641 * _e642) - (_e639 * _e644)) * _e635)) + (((_e639 * _e643) - (_e640 * _e642)) * _e638));
let _e660 = select(0f, _e658, (_e658 > 0f));
let _e661 = (_e551 - _e492);
let _e662 = (_e560 - _e493);
let _e663 = (_e569 - _e494);
let _e677 = (((((_e643 * _e663) - (_e644 * _e662)) * _e632) + (((_e644 * _e661) - (_e642 * _e663)) * _e635)) + (((_e642 * _e662) - (_e643 * _e661)) * _e638));
let _e679 = select(0f, _e677, (_e677 > 0f));
let _e693 = (((((_e662 * _e641) - (_e663 * _e640)) * _e632) + (((_e663 * _e639) - (_e661 * _e641)) * _e635)) + (((_e661 * _e640) - (_e662 * _e639)) * _e638));
let _e695 = select(0f, _e693, (_e693 > 0f));
let _e697 = ((_e660 + _e679) + _e695);
let _e699 = select(1e-30f, _e697, (_e697 > 1e-30f));
let _e700 = (_e660 / _e699);
let _e701 = (_e679 / _e699);
let _e702 = (_e695 / _e699);
let _e707 = (((_e632 * _e632) + (_e635 * _e635)) + (_e638 * _e638));
let _e710 = sqrt(select(0f, _e707, (_e707 > 0f)));
let _e713 = (1f / select(1e-20f, _e710, (_e710 > 1e-20f)));
let _e718 = (_e543 + 9i);
let _e720 = select(_e197, _e718, (_e718 < _e197));
let _e726 = global_3.member[bitcast<u32>(select(0i, _e720, (_e720 > 0i)))];
let _e727 = (_e543 + 10i);
let _e729 = select(_e197, _e727, (_e727 < _e197));
let _e735 = global_3.member[bitcast<u32>(select(0i, _e729, (_e729 > 0i)))];
let _e736 = (_e543 + 11i);
let _e738 = select(_e197, _e736, (_e736 < _e197));
let _e744 = global_3.member[bitcast<u32>(select(0i, _e738, (_e738 > 0i)))];
let _e748 = (_e543 + 12i);
let _e750 = select(_e197, _e748, (_e748 < _e197));
let _e756 = global_3.member[bitcast<u32>(select(0i, _e750, (_e750 > 0i)))];
let _e757 = (_e543 + 13i);
let _e759 = select(_e197, _e757, (_e757 < _e197));
let _e765 = global_3.member[bitcast<u32>(select(0i, _e759, (_e759 > 0i)))];
let _e766 = (_e543 + 14i);
let _e768 = select(_e197, _e766, (_e766 < _e197));
let _e774 = global_3.member[bitcast<u32>(select(0i, _e768, (_e768 > 0i)))];
let _e781 = (_e543 + 15i);
let _e783 = select(_e197, _e781, (_e781 < _e197));
let _e789 = global_3.member[bitcast<u32>(select(0i, _e783, (_e783 > 0i)))];
let _e790 = (_e543 + 16i);
let _e792 = select(_e197, _e790, (_e790 < _e197));
let _e798 = global_3.member[bitcast<u32>(select(0i, _e792, (_e792 > 0i)))];
let _e799 = (_e543 + 17i);
let _e801 = select(_e197, _e799, (_e799 < _e197));
let _e807 = global_3.member[bitcast<u32>(select(0i, _e801, (_e801 > 0i)))];
let _e811 = (((_e726 * _e700) + (_e756 * _e701)) + (_e789 * _e702));
let _e812 = (((_e735 * _e700) + (_e765 * _e701)) + (_e798 * _e702));
let _e813 = (((_e744 * _e700) + (_e774 * _e701)) + (_e807 * _e702));
let _e818 = (((_e811 * _e811) + (_e812 * _e812)) + (_e813 * _e813));
let _e821 = sqrt(select(0f, _e818, (_e818 > 0f)));
let _e824 = (1f / select(1e-20f, _e821, (_e821 > 1e-20f)));
let _e829 = (_e543 + 18i);
let _e831 = select(_e197, _e829, (_e829 < _e197));
let _e837 = global_3.member[bitcast<u32>(select(0i, _e831, (_e831 > 0i)))];
let _e846 = (select(select(0i, select(select(i32(_e837), i32(-2147483648), (_e837 < -2147483600f)), 2147483647i, (_e837 > 2147483500f)), (_e837 == _e837)), _e393, ((_e233 & 1u) != 0u)) * 10i);
let _e848 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e850 = select(_e848, _e846, (_e846 < _e848));
let _e856 = global_4.member[bitcast<u32>(select(0i, _e850, (_e850 > 0i)))];
let _e857 = (_e846 + 1i);
let _e859 = select(_e848, _e857, (_e857 < _e848));
let _e865 = global_4.member[bitcast<u32>(select(0i, _e859, (_e859 > 0i)))];
let _e866 = (_e846 + 2i);
let _e868 = select(_e848, _e866, (_e866 < _e848));
let _e874 = global_4.member[bitcast<u32>(select(0i, _e868, (_e868 > 0i)))];
let _e878 = (_e846 + 3i);
let _e880 = select(_e848, _e878, (_e878 < _e848));
let _e886 = global_4.member[bitcast<u32>(select(0i, _e880, (_e880 > 0i)))];
let _e887 = (_e846 + 4i);
let _e889 = select(_e848, _e887, (_e887 < _e848));
let _e895 = global_4.member[bitcast<u32>(select(0i, _e889, (_e889 > 0i)))];
let _e896 = (_e846 + 5i);
let _e898 = select(_e848, _e896, (_e896 < _e848));
let _e904 = global_4.member[bitcast<u32>(select(0i, _e898, (_e898 > 0i)))];
let _e911 = (_e846 + 6i);
let _e913 = select(_e848, _e911, (_e911 < _e848));
let _e919 = global_4.member[bitcast<u32>(select(0i, _e913, (_e913 > 0i)))];
let _e920 = (_e846 + 7i);
let _e922 = select(_e848, _e920, (_e920 < _e848));
let _e928 = global_4.member[bitcast<u32>(select(0i, _e922, (_e922 > 0i)))];
let _e929 = (_e846 + 8i);
let _e931 = select(_e848, _e929, (_e929 < _e848));
let _e937 = global_4.member[bitcast<u32>(select(0i, _e931, (_e931 > 0i)))];
let _e945 = (_e846 + 9i);
let _e947 = select(_e848, _e945, (_e945 < _e848));
let _e953 = global_4.member[bitcast<u32>(select(0i, _e947, (_e947 > 0i)))];
phi_2238_ = type_27(_e495, vec3<f32>((_e632 * _e713), (_e635 * _e713), (_e638 * _e713)), vec3<f32>((_e811 * _e824), (_e812 * _e824), (_e813 * _e824)), vec3<f32>((((_e856 * _e700) + (_e886 * _e701)) + (_e919 * _e702)), (((_e865 * _e700) + (_e895 * _e701)) + (_e928 * _e702)), (((_e874 * _e700) + (_e904 * _e701)) + (_e937 * _e702))), _e953, true, false);
} else {
let _e499 = (_e393 == -3i);
let _e505 = global_1.member.member_14.member_1.member.member;
let _e510 = global_1.member.member_14.member_1.member_1;
let _e516 = global_1.member.member_14.member.member.member;
let _e521 = global_1.member.member_14.member.member_1;
let _e531 = vec3<f32>(select(_e516.member, _e505.member, _e499), select(_e516.member_1, _e505.member_1, _e499), select(_e516.member_2, _e505.member_2, _e499));
phi_2238_ = type_27(_e495, _e531, _e531, vec3<f32>(select(_e521.member, _e510.member, _e499), select(_e521.member_1, _e510.member_1, _e499), select(_e521.member_2, _e510.member_2, _e499)), 0f, false, _e499);
}
let _e956 = phi_2238_;
let _e960 = global_1.member.member_10.member;
let _e961 = (_e960 == 0u);
let _e965 = global_1.member.member_10.member_3;
let _e971 = (_e965.member - _e956.member.x);
let _e973 = (_e965.member_1 - _e956.member.y);
let _e975 = (_e965.member_2 - _e956.member.z);
let _e980 = (((_e971 * _e971) + (_e973 * _e973)) + (_e975 * _e975));
let _e983 = sqrt(select(0f, _e980, (_e980 > 0f)));
if _e961 {
let _e992 = global_1.member.member_10.member_1;
phi_2350_ = vec3<f32>(-(_e992.member), -(_e992.member_1), -(_e992.member_2));
} else {
let _e984 = (1f / _e983);
phi_2350_ = vec3<f32>((_e971 * _e984), (_e973 * _e984), (_e975 * _e984));
}
let _e1001 = phi_2350_;
let _e1016 = select(0.05f, -(0.05f), ((((_e956.member_1.x * _e1001.x) + (_e956.member_1.y * _e1001.y)) + (_e956.member_1.z * _e1001.z)) < 0f));
let _e1022 = select(_e983, 1e30f, _e961);
phi_2404_ = type_19((_e956.member + vec3<f32>((_e956.member_1.x * _e1016), (_e956.member_1.y * _e1016), (_e956.member_1.z * _e1016))), _e1001, vec3<f32>(1f, 1f, 1f), vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), 1e9f, 0f, 16i, 0f, 0f, 0f, 0f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), 0i, _e291.member_1, -1i, _e1022);
phi_2407_ = 0i;
phi_2409_ = _e291;
loop {
let _e1026 = phi_2404_;
let _e1028 = phi_2407_;
let _e1030 = phi_2409_;
local_2 = _e1030;
let _e1037 = (((_e1028 < 1024i) && (_e1026.member_15 < _e186)) && (_e1030.member_2 <= 0f));
local_3 = _e1026.member_15;
local_4 = _e1030.member_2;
if _e1037 {
let _e1046 = (_e1026.member_15 * 8i);
let _e1054 = (1f / select(_e1026.member_1.x, select(1e-12f, -1e-12f, (_e1026.member_1.x < 0f)), (bitcast<f32>((bitcast<u32>(_e1026.member_1.x) & 2147483647u)) < 1e-12f)));
let _e1062 = (1f / select(_e1026.member_1.y, select(1e-12f, -1e-12f, (_e1026.member_1.y < 0f)), (bitcast<f32>((bitcast<u32>(_e1026.member_1.y) & 2147483647u)) < 1e-12f)));
let _e1070 = (1f / select(_e1026.member_1.z, select(1e-12f, -1e-12f, (_e1026.member_1.z < 0f)), (bitcast<f32>((bitcast<u32>(_e1026.member_1.z) & 2147483647u)) < 1e-12f)));
let _e1072 = (_e185 - 1i);
let _e1074 = select(_e1072, _e1046, (_e1046 < _e1072));
let _e1080 = global_6.member[bitcast<u32>(select(0i, _e1074, (_e1074 > 0i)))];
let _e1081 = (_e1046 + 1i);
let _e1083 = select(_e1072, _e1081, (_e1081 < _e1072));
let _e1089 = global_6.member[bitcast<u32>(select(0i, _e1083, (_e1083 > 0i)))];
let _e1090 = (_e1046 + 2i);
let _e1092 = select(_e1072, _e1090, (_e1090 < _e1072));
let _e1098 = global_6.member[bitcast<u32>(select(0i, _e1092, (_e1092 > 0i)))];
let _e1099 = (_e1046 + 3i);
let _e1101 = select(_e1072, _e1099, (_e1099 < _e1072));
let _e1107 = global_6.member[bitcast<u32>(select(0i, _e1101, (_e1101 > 0i)))];
let _e1108 = (_e1046 + 4i);
let _e1110 = select(_e1072, _e1108, (_e1108 < _e1072));
let _e1116 = global_6.member[bitcast<u32>(select(0i, _e1110, (_e1110 > 0i)))];
let _e1117 = (_e1046 + 5i);
let _e1119 = select(_e1072, _e1117, (_e1117 < _e1072));
let _e1125 = global_6.member[bitcast<u32>(select(0i, _e1119, (_e1119 > 0i)))];
let _e1128 = ((_e1080 - _e1026.member.x) * _e1054);
let _e1130 = ((_e1107 - _e1026.member.x) * _e1054);
let _e1133 = ((_e1089 - _e1026.member.y) * _e1062);
let _e1135 = ((_e1116 - _e1026.member.y) * _e1062);
let _e1138 = ((_e1098 - _e1026.member.z) * _e1070);
let _e1140 = ((_e1125 - _e1026.member.z) * _e1070);
let _e1142 = select(_e1130, _e1128, (_e1128 < _e1130));
let _e1144 = select(_e1135, _e1133, (_e1133 < _e1135));
let _e1146 = select(_e1144, _e1142, (_e1142 > _e1144));
let _e1148 = select(_e1140, _e1138, (_e1138 < _e1140));
let _e1152 = select(_e1130, _e1128, (_e1128 > _e1130));
let _e1154 = select(_e1135, _e1133, (_e1133 > _e1135));
let _e1156 = select(_e1154, _e1152, (_e1152 < _e1154));
let _e1158 = select(_e1140, _e1138, (_e1138 > _e1140));
let _e1160 = select(_e1158, _e1156, (_e1156 < _e1158));
let _e1165 = ((select(_e1148, _e1146, (_e1146 > _e1148)) <= select(_e1026.member_17, _e1160, (_e1160 < _e1026.member_17))) && (_e1160 >= 0f));
let _e1166 = (_e1046 + 6i);
let _e1168 = select(_e1072, _e1166, (_e1166 < _e1072));
let _e1174 = global_6.member[bitcast<u32>(select(0i, _e1168, (_e1168 > 0i)))];
if _e1165 {
phi_2702_ = (_e1026.member_15 + 1i);
} else {
let _e1182 = (_e1046 + 7i);
let _e1184 = select(_e1072, _e1182, (_e1182 < _e1072));
let _e1190 = global_6.member[bitcast<u32>(select(0i, _e1184, (_e1184 > 0i)))];
phi_2702_ = select(0i, select(select(i32(_e1190), i32(-2147483648), (_e1190 < -2147483600f)), 2147483647i, (_e1190 > 2147483500f)), (_e1190 == _e1190));
}
let _e1200 = phi_2702_;
let _e1218 = type_19(_e1026.member, _e1026.member_1, _e1026.member_2, _e1026.member_3, _e1026.member_4, _e1026.member_5, _e1026.member_6, _e1026.member_7, _e1026.member_8, _e1026.member_9, _e1026.member_10, _e1026.member_11, _e1026.member_12, _e1026.member_13, _e1026.member_14, _e1200, _e1026.member_16, _e1026.member_17);
let _e1219 = select(-1i, select(0i, select(select(i32(_e1174), i32(-2147483648), (_e1174 < -2147483600f)), 2147483647i, (_e1174 > 2147483500f)), (_e1174 == _e1174)), _e1165);
if (_e1219 >= 0i) {
let _e1225 = bitcast<f32>((bitcast<u32>(_e1026.member_1.x) & 2147483647u));
let _e1229 = bitcast<f32>((bitcast<u32>(_e1026.member_1.y) & 2147483647u));
let _e1233 = bitcast<f32>((bitcast<u32>(_e1026.member_1.z) & 2147483647u));
let _e1236 = ((_e1225 >= _e1229) && (_e1225 >= _e1233));
let _e1239 = (!(_e1236) && (_e1229 >= _e1233));
let _e1246 = (1f / select(select(_e1026.member_1.z, _e1026.member_1.y, _e1239), _e1026.member_1.x, _e1236));
let _e1247 = (select(select(_e1026.member_1.x, _e1026.member_1.z, _e1239), _e1026.member_1.y, _e1236) * _e1246);
let _e1248 = (select(select(_e1026.member_1.y, _e1026.member_1.x, _e1239), _e1026.member_1.z, _e1236) * _e1246);
let _e1249 = (_e1219 * 19i);
let _e1251 = select(_e197, _e1249, (_e1249 < _e197));
let _e1257 = global_3.member[bitcast<u32>(select(0i, _e1251, (_e1251 > 0i)))];
let _e1258 = (_e1249 + 1i);
let _e1260 = select(_e197, _e1258, (_e1258 < _e197));
let _e1266 = global_3.member[bitcast<u32>(select(0i, _e1260, (_e1260 > 0i)))];
let _e1267 = (_e1249 + 2i);
let _e1269 = select(_e197, _e1267, (_e1267 < _e197));
let _e1275 = global_3.member[bitcast<u32>(select(0i, _e1269, (_e1269 > 0i)))];
let _e1276 = (_e1257 - _e1026.member.x);
let _e1277 = (_e1266 - _e1026.member.y);
let _e1278 = (_e1275 - _e1026.member.z);
let _e1284 = select(select(_e1278, _e1277, _e1239), _e1276, _e1236);
let _e1286 = (select(select(_e1276, _e1278, _e1239), _e1277, _e1236) - (_e1247 * _e1284));
let _e1288 = (select(select(_e1277, _e1276, _e1239), _e1278, _e1236) - (_e1248 * _e1284));
let _e1290 = (_e1249 + 3i);
let _e1292 = select(_e197, _e1290, (_e1290 < _e197));
let _e1298 = global_3.member[bitcast<u32>(select(0i, _e1292, (_e1292 > 0i)))];
let _e1299 = (_e1249 + 4i);
let _e1301 = select(_e197, _e1299, (_e1299 < _e197));
let _e1307 = global_3.member[bitcast<u32>(select(0i, _e1301, (_e1301 > 0i)))];
let _e1308 = (_e1249 + 5i);
let _e1310 = select(_e197, _e1308, (_e1308 < _e197));
let _e1316 = global_3.member[bitcast<u32>(select(0i, _e1310, (_e1310 > 0i)))];
let _e1317 = (_e1298 - _e1026.member.x);
let _e1318 = (_e1307 - _e1026.member.y);
let _e1319 = (_e1316 - _e1026.member.z);
let _e1325 = select(select(_e1319, _e1318, _e1239), _e1317, _e1236);
let _e1327 = (select(select(_e1317, _e1319, _e1239), _e1318, _e1236) - (_e1247 * _e1325));
let _e1329 = (select(select(_e1318, _e1317, _e1239), _e1319, _e1236) - (_e1248 * _e1325));
let _e1331 = (_e1249 + 6i);
let _e1333 = select(_e197, _e1331, (_e1331 < _e197));
let _e1339 = global_3.member[bitcast<u32>(select(0i, _e1333, (_e1333 > 0i)))];
let _e1340 = (_e1249 + 7i);
let _e1342 = select(_e197, _e1340, (_e1340 < _e197));
let _e1348 = global_3.member[bitcast<u32>(select(0i, _e1342, (_e1342 > 0i)))];
let _e1349 = (_e1249 + 8i);
let _e1351 = select(_e197, _e1349, (_e1349 < _e197));
let _e1357 = global_3.member[bitcast<u32>(select(0i, _e1351, (_e1351 > 0i)))];
let _e1358 = (_e1339 - _e1026.member.x);
let _e1359 = (_e1348 - _e1026.member.y);
let _e1360 = (_e1357 - _e1026.member.z);
let _e1366 = select(select(_e1360, _e1359, _e1239), _e1358, _e1236);
let _e1368 = (select(select(_e1358, _e1360, _e1239), _e1359, _e1236) - (_e1247 * _e1366));
let _e1370 = (select(select(_e1359, _e1358, _e1239), _e1360, _e1236) - (_e1248 * _e1366));
let _e1374 = ((_e1368 * _e1329) - (_e1370 * _e1327));
let _e1377 = ((_e1286 * _e1370) - (_e1288 * _e1368));
let _e1380 = ((_e1327 * _e1288) - (_e1329 * _e1286));
let _e1382 = ((_e1374 + _e1377) + _e1380);
let _e1396 = (!(((((_e1374 < 0f) || (_e1377 < 0f)) || (_e1380 < 0f)) && (((_e1374 > 0f) || (_e1377 > 0f)) || (_e1380 > 0f)))) && (_e1382 != 0f));
let _e1404 = select(1e30f, ((((_e1374 * (_e1284 * _e1246)) + (_e1377 * (_e1325 * _e1246))) + (_e1380 * (_e1366 * _e1246))) / select(1f, _e1382, _e1396)), _e1396);
let _e1406 = select(1e30f, _e1404, (_e1404 > 1e-3f));
if (_e1406 < _e1026.member_17) {
phi_3069_ = type_19(_e1218.member, _e1218.member_1, _e1218.member_2, _e1218.member_3, _e1218.member_4, _e1218.member_5, _e1218.member_6, _e1218.member_7, _e1218.member_8, _e1218.member_9, _e1218.member_10, _e1218.member_11, _e1218.member_12, _e1218.member_13, _e1218.member_14, _e1218.member_15, _e1218.member_16, _e1406);
} else {
phi_3069_ = _e1218;
}
let _e1427 = phi_3069_;
phi_3070_ = _e1427;
} else {
phi_3070_ = _e1218;
}
let _e1429 = phi_3070_;
if (_e1429.member_17 < _e1022) {
phi_3077_ = type_28(_e1030.member, _e1030.member_1, 1f);
} else {
phi_3077_ = _e1030;
}
let _e1436 = phi_3077_;
phi_2405_ = _e1429;
phi_2408_ = (_e1028 + 1i);
phi_2410_ = _e1436;
} else {
phi_2405_ = type_19();
phi_2408_ = i32();
phi_2410_ = type_28();
}
let _e1438 = phi_2405_;
let _e1440 = phi_2408_;
let _e1442 = phi_2410_;
continue;
continuing {
phi_2404_ = _e1438;
phi_2407_ = _e1440;
phi_2409_ = _e1442;
break if !(_e1037);
}
}
let _e1445 = local_2;
let _e1449 = local_3;
global_5.member[_e99] = f32(_e1445.member);
global_5.member[_e111] = f32(_e1449);
let _e1458 = local_4;
global_5.member[_e122] = _e1458;
}
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
