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
struct type_11 {
member: array<f32>,
}
struct type_16 {
member: array<u32>,
}
struct type_17 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
}
struct type_18 {
member: u32,
member_1: u32,
}
struct type_19 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
}
struct type_20 {
member: type_7,
member_1: type_7,
member_2: type_7,
member_3: type_5,
member_4: f32,
member_5: f32,
member_6: f32,
member_7: i32,
member_8: i32,
member_9: type_2,
member_10: u32,
member_11: type_2,
member_12: u32,
}
struct type_21 {
member: u32,
member_1: u32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
member_6: f32,
member_7: f32,
member_8: f32,
}
struct type_22 {
member: type_5,
member_1: type_5,
}
struct type_23 {
member: type_7,
member_1: u32,
}
struct type_24 {
member: type_2,
member_1: u32,
member_2: type_17,
member_3: type_18,
member_4: u32,
member_5: type_19,
member_6: type_20,
member_7: type_20,
member_8: type_21,
member_9: type_22,
member_10: f32,
member_11: type_19,
member_12: type_4,
member_13: type_9,
member_14: type_23,
member_15: type_23,
member_16: type_23,
member_17: type_23,
member_18: type_5,
member_19: f32,
member_20: f32,
member_21: type_6,
}
struct type_25 {
member: type_24,
}
struct type_28 {
member: array<i32, 4>,
member_1: array<u32, 6>,
}
struct type_29 {
member: f32,
member_1: vec3<f32>,
member_2: vec3<f32>,
}
struct type_30 {
member: f32,
member_1: vec3<f32>,
member_2: f32,
member_3: vec3<f32>,
member_4: vec3<f32>,
}
struct type_31 {
member: f32,
member_1: f32,
member_2: vec3<f32>,
member_3: vec3<f32>,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_25;
@group(0) @binding(1)
var<storage> global_2: type_16;
@group(0) @binding(3)
var<storage> global_3: type_16;
@group(0) @binding(4)
var<storage> global_4: type_16;
@group(0) @binding(6)
var<storage, read_write> global_5: type_11;
@group(0) @binding(5)
var<storage> global_6: type_11;
fn function_() {
var local: type_28;
var local_1: vec3<f32>;
var local_2: type_28;
var local_3: vec3<f32>;
var local_4: type_28;
var local_5: vec3<f32>;
var phi_939_: u32;
var phi_3132_: type_29;
var phi_3741_: type_30;
var phi_4537_: type_5;
var phi_5647_: type_31;
var phi_5798_: f32;
var phi_5799_: f32;
var phi_5800_: f32;
var phi_5801_: f32;
let _e85 = global;
let _e88 = arrayLength((&global_2.member));
let _e92 = arrayLength((&global_4.member));
let _e94 = arrayLength((&global_6.member));
let _e99 = global_1.member.member_2;
let _e102 = global_1.member.member;
let _e110 = (_e85.x + _e99.member);
let _e112 = (_e85.y + _e99.member_1);
if (_e110 < _e99.member_2) {
if (_e112 < _e99.member_3) {
let _e115 = (_e102.member * _e102.member_1);
let _e117 = ((_e112 * _e102.member) + _e110);
let _e118 = bitcast<i32>(_e117);
let _e120 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e122 = select(_e120, _e118, (_e118 < _e120));
let _e128 = global_5.member[bitcast<u32>(select(0i, _e122, (_e122 > 0i)))];
let _e129 = (_e115 + _e117);
let _e130 = bitcast<i32>(_e129);
let _e132 = select(_e120, _e130, (_e130 < _e120));
let _e138 = global_5.member[bitcast<u32>(select(0i, _e132, (_e132 > 0i)))];
let _e140 = ((2u * _e115) + _e117);
let _e141 = bitcast<i32>(_e140);
let _e143 = select(_e120, _e141, (_e141 < _e120));
let _e149 = global_5.member[bitcast<u32>(select(0i, _e143, (_e143 > 0i)))];
let _e151 = ((3u * _e115) + _e117);
let _e152 = bitcast<i32>(_e151);
let _e154 = select(_e120, _e152, (_e152 < _e120));
let _e160 = global_5.member[bitcast<u32>(select(0i, _e154, (_e154 > 0i)))];
let _e162 = ((4u * _e115) + _e117);
let _e163 = bitcast<i32>(_e162);
let _e165 = select(_e120, _e163, (_e163 < _e120));
let _e171 = global_5.member[bitcast<u32>(select(0i, _e165, (_e165 > 0i)))];
let _e173 = ((5u * _e115) + _e117);
let _e174 = bitcast<i32>(_e173);
let _e176 = select(_e120, _e174, (_e174 < _e120));
let _e182 = global_5.member[bitcast<u32>(select(0i, _e176, (_e176 > 0i)))];
let _e184 = ((6u * _e115) + _e117);
let _e185 = bitcast<i32>(_e184);
let _e187 = select(_e120, _e185, (_e185 < _e120));
let _e193 = global_5.member[bitcast<u32>(select(0i, _e187, (_e187 > 0i)))];
let _e195 = ((7u * _e115) + _e117);
let _e196 = bitcast<i32>(_e195);
let _e198 = select(_e120, _e196, (_e196 < _e120));
let _e204 = global_5.member[bitcast<u32>(select(0i, _e198, (_e198 > 0i)))];
let _e206 = ((8u * _e115) + _e117);
let _e207 = bitcast<i32>(_e206);
let _e209 = select(_e120, _e207, (_e207 < _e120));
let _e215 = global_5.member[bitcast<u32>(select(0i, _e209, (_e209 > 0i)))];
let _e219 = global_1.member.member_8.member;
let _e223 = global_1.member.member_8.member_1;
let _e224 = (_e219 * _e223);
if (_e94 >= (_e224 * 2u)) {
let _e228 = bitcast<i32>((_e112 * _e219));
let _e230 = bitcast<i32>(_e110);
let _e235 = global_6.member[bitcast<u32>((_e228 + _e230))];
let _e241 = global_6.member[bitcast<u32>(((bitcast<i32>(_e224) + _e228) + _e230))];
let _e242 = f32(_e230);
let _e244 = f32(bitcast<i32>(_e112));
let _e250 = global_1.member.member_5.member;
let _e254 = global_1.member.member_8.member_8;
let _e255 = (_e250 - _e254);
let _e259 = global_1.member.member_8.member_2;
let _e263 = global_1.member.member_8.member_6;
let _e270 = global_1.member.member_8.member_4;
let _e272 = ((_e259 + (_e263 * _e255)) + (((_e242 - _e235) + 0.5f) * _e270));
let _e276 = global_1.member.member_8.member_3;
let _e280 = global_1.member.member_8.member_7;
let _e285 = ((_e276 + (_e280 * _e255)) + (((_e244 - _e241) + 0.5f) * _e270));
let _e289 = global_1.member.member_5.member_1;
let _e290 = (_e289 - _e254);
let _e295 = ((_e259 + (_e263 * _e290)) + ((_e242 + 0.5f) * _e270));
let _e300 = ((_e276 + (_e280 * _e290)) + ((_e244 + 0.5f) * _e270));
let _e304 = global_1.member.member_6.member;
let _e315 = ((((_e304.member.member * _e272) + (_e304.member.member_1 * _e285)) + (_e304.member.member_2 * _e250)) + _e304.member_1);
let _e319 = global_1.member.member_6.member_1;
let _e330 = ((((_e319.member.member * _e272) + (_e319.member.member_1 * _e285)) + (_e319.member.member_2 * _e250)) + _e319.member_1);
let _e334 = global_1.member.member_6.member_2;
let _e345 = ((((_e334.member.member * _e272) + (_e334.member.member_1 * _e285)) + (_e334.member.member_2 * _e250)) + _e334.member_1);
let _e351 = ((((_e304.member.member * _e295) + (_e304.member.member_1 * _e300)) + (_e304.member.member_2 * _e289)) + _e304.member_1);
let _e357 = ((((_e319.member.member * _e295) + (_e319.member.member_1 * _e300)) + (_e319.member.member_2 * _e289)) + _e319.member_1);
let _e363 = ((((_e334.member.member * _e295) + (_e334.member.member_1 * _e300)) + (_e334.member.member_2 * _e289)) + _e334.member_1);
let _e369 = global_1.member.member_6.member_3.member;
let _e370 = (_e369 - 1f);
let _e379 = global_1.member.member_6.member_3.member_1;
let _e380 = (_e379 - 1f);
let _e389 = global_1.member.member_6.member_3.member_2;
let _e390 = (_e389 - 1f);
let _e409 = global_1.member.member_6.member_4;
let _e410 = (_e369 - 0.5f);
let _e412 = select(-0.5f, _e351, (_e351 > -0.5f));
let _e414 = select(_e410, _e412, (_e412 < _e410));
let _e415 = (_e379 - 0.5f);
let _e417 = select(-0.5f, _e357, (_e357 > -0.5f));
let _e419 = select(_e415, _e417, (_e417 < _e415));
let _e420 = (_e389 - 0.5f);
let _e422 = select(-0.5f, _e363, (_e363 > -0.5f));
let _e424 = select(_e420, _e422, (_e422 < _e420));
let _e430 = bitcast<f32>((bitcast<u32>((_e351 - _e315)) & 2147483647u));
let _e433 = bitcast<f32>((bitcast<u32>((_e357 - _e330)) & 2147483647u));
let _e435 = select(_e433, _e430, (_e430 > _e433));
let _e438 = bitcast<f32>((bitcast<u32>((_e363 - _e345)) & 2147483647u));
let _e447 = bitcast<f32>((bitcast<u32>((_e351 - _e414)) & 2147483647u));
let _e450 = bitcast<f32>((bitcast<u32>((_e357 - _e419)) & 2147483647u));
let _e452 = select(_e450, _e447, (_e447 > _e450));
let _e455 = bitcast<f32>((bitcast<u32>((_e363 - _e424)) & 2147483647u));
let _e459 = (_e414 + 0.5f);
let _e461 = select(0f, _e459, (_e459 > 0f));
let _e463 = select(_e370, _e461, (_e461 < _e370));
let _e470 = select(0i, select(select(i32(_e463), i32(-2147483648), (_e463 < -2147483600f)), 2147483647i, (_e463 > 2147483500f)), (_e463 == _e463));
let _e478 = global_1.member.member_6.member_12;
let _e479 = (_e478 & 31u);
let _e482 = (_e419 + 0.5f);
let _e484 = select(0f, _e482, (_e482 > 0f));
let _e486 = select(_e380, _e484, (_e484 < _e380));
let _e493 = select(0i, select(select(i32(_e486), i32(-2147483648), (_e486 < -2147483600f)), 2147483647i, (_e486 > 2147483500f)), (_e486 == _e486));
let _e500 = (_e424 + 0.5f);
let _e502 = select(0f, _e500, (_e500 > 0f));
let _e504 = select(_e390, _e502, (_e502 < _e390));
let _e511 = select(0i, select(select(i32(_e504), i32(-2147483648), (_e504 < -2147483600f)), 2147483647i, (_e504 > 2147483500f)), (_e504 == _e504));
let _e522 = global_1.member.member_6.member_9.member;
let _e528 = global_1.member.member_6.member_9.member_1;
let _e533 = global_1.member.member_6.member_10;
let _e539 = ((bitcast<i32>(_e533) + ((_e470 - select(0i, 1i, (_e463 < f32(_e470)))) >> bitcast<u32>(_e479))) + (bitcast<i32>(_e522) * (((_e493 - select(0i, 1i, (_e486 < f32(_e493)))) >> bitcast<u32>(_e479)) + (bitcast<i32>(_e528) * ((_e511 - select(0i, 1i, (_e504 < f32(_e511)))) >> bitcast<u32>(_e479))))));
let _e541 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e543 = select(_e541, _e539, (_e539 < _e541));
let _e549 = global_3.member[bitcast<u32>(select(0i, _e543, (_e543 > 0i)))];
let _e555 = global_1.member.member_1;
phi_939_ = select(select(7u, 3u, (((((((_e315 >= 0f) && (_e315 <= _e370)) && (_e330 >= 0f)) && (_e330 <= _e380)) && (_e345 >= 0f)) && (_e345 <= _e390)) && ((((((_e351 >= 0f) && (_e351 <= _e370)) && (_e357 >= 0f)) && (_e357 <= _e380)) && (_e363 >= 0f)) && (_e363 <= _e390)))), 1u, (((_e555 & 64u) != 0u) || ((((select(_e438, _e435, (_e435 > _e438)) <= _e409) && ((select(_e455, _e452, (_e452 > _e455)) > _e409) || (_e549 != 0u))) && true) && ((_e555 & 32u) != 0u))));
} else {
phi_939_ = 7u;
}
let _e565 = phi_939_;
if (_e565 > 1u) {
let _e570 = bitcast<i32>(((_e112 * _e219) + _e110));
let _e573 = (bitcast<i32>(_e94) - 1i);
let _e575 = select(_e573, _e570, (_e570 < _e573));
let _e581 = global_6.member[bitcast<u32>(select(0i, _e575, (_e575 > 0i)))];
let _e582 = (bitcast<i32>(_e224) + _e570);
let _e584 = select(_e573, _e582, (_e582 < _e573));
let _e590 = global_6.member[bitcast<u32>(select(0i, _e584, (_e584 > 0i)))];
let _e592 = f32(bitcast<i32>(_e110));
let _e594 = f32(bitcast<i32>(_e112));
let _e600 = global_1.member.member_5.member;
let _e604 = global_1.member.member_8.member_8;
let _e605 = (_e600 - _e604);
let _e609 = global_1.member.member_8.member_2;
let _e613 = global_1.member.member_8.member_6;
let _e620 = global_1.member.member_8.member_4;
let _e622 = ((_e609 + (_e613 * _e605)) + (((_e592 - _e581) + 0.5f) * _e620));
let _e626 = global_1.member.member_8.member_3;
let _e630 = global_1.member.member_8.member_7;
let _e635 = ((_e626 + (_e630 * _e605)) + (((_e594 - _e590) + 0.5f) * _e620));
let _e639 = global_1.member.member_5.member_1;
let _e640 = (_e639 - _e604);
let _e645 = ((_e609 + (_e613 * _e640)) + ((_e592 + 0.5f) * _e620));
let _e650 = ((_e626 + (_e630 * _e640)) + ((_e594 + 0.5f) * _e620));
let _e654 = global_1.member.member_6.member;
let _e665 = ((((_e654.member.member * _e622) + (_e654.member.member_1 * _e635)) + (_e654.member.member_2 * _e600)) + _e654.member_1);
let _e669 = global_1.member.member_6.member_1;
let _e680 = ((((_e669.member.member * _e622) + (_e669.member.member_1 * _e635)) + (_e669.member.member_2 * _e600)) + _e669.member_1);
let _e684 = global_1.member.member_6.member_2;
let _e695 = ((((_e684.member.member * _e622) + (_e684.member.member_1 * _e635)) + (_e684.member.member_2 * _e600)) + _e684.member_1);
let _e701 = ((((_e654.member.member * _e645) + (_e654.member.member_1 * _e650)) + (_e654.member.member_2 * _e639)) + _e654.member_1);
let _e707 = ((((_e669.member.member * _e645) + (_e669.member.member_1 * _e650)) + (_e669.member.member_2 * _e639)) + _e669.member_1);
let _e713 = ((((_e684.member.member * _e645) + (_e684.member.member_1 * _e650)) + (_e684.member.member_2 * _e639)) + _e684.member_1);
let _e715 = (_e102.member_2 == 2u);
let _e718 = (((_e102.member_2 == 1u) || _e715) || (_e102.member_2 == 5u));
if _e718 {
let _e723 = global_1.member.member_6.member_3.member;
let _e724 = (_e723 - 0.5f);
let _e726 = select(-0.5f, _e701, (_e701 > -0.5f));
let _e728 = select(_e724, _e726, (_e726 < _e724));
let _e733 = global_1.member.member_6.member_3.member_1;
let _e734 = (_e733 - 0.5f);
let _e736 = select(-0.5f, _e707, (_e707 > -0.5f));
let _e738 = select(_e734, _e736, (_e736 < _e734));
let _e743 = global_1.member.member_6.member_3.member_2;
let _e744 = (_e743 - 0.5f);
let _e746 = select(-0.5f, _e713, (_e713 > -0.5f));
let _e748 = select(_e744, _e746, (_e746 < _e744));
let _e750 = select(-1f, _e728, (_e728 > -1f));
let _e752 = select(_e723, _e750, (_e750 < _e723));
let _e759 = select(0i, select(select(i32(_e752), i32(-2147483648), (_e752 < -2147483600f)), 2147483647i, (_e752 > 2147483500f)), (_e752 == _e752));
let _e763 = (_e759 - select(0i, 1i, (_e752 < f32(_e759))));
let _e765 = select(-1f, _e738, (_e738 > -1f));
let _e767 = select(_e733, _e765, (_e765 < _e733));
let _e774 = select(0i, select(select(i32(_e767), i32(-2147483648), (_e767 < -2147483600f)), 2147483647i, (_e767 > 2147483500f)), (_e767 == _e767));
let _e778 = (_e774 - select(0i, 1i, (_e767 < f32(_e774))));
let _e780 = select(-1f, _e748, (_e748 > -1f));
let _e782 = select(_e743, _e780, (_e780 < _e743));
let _e789 = select(0i, select(select(i32(_e782), i32(-2147483648), (_e782 < -2147483600f)), 2147483647i, (_e782 > 2147483500f)), (_e782 == _e782));
let _e793 = (_e789 - select(0i, 1i, (_e782 < f32(_e789))));
let _e797 = global_1.member.member_6.member_7;
let _e801 = global_1.member.member_6.member_8;
let _e802 = (_e763 + 1i);
let _e803 = (_e778 + 1i);
let _e804 = (_e793 + 1i);
let _e809 = global_1.member.member_6.member_11.member;
let _e815 = global_1.member.member_6.member_11.member_1;
let _e826 = ((_e802 >> bitcast<u32>(4i)) + (bitcast<i32>(_e809) * ((_e803 >> bitcast<u32>(4i)) + (bitcast<i32>(_e815) * (_e804 >> bitcast<u32>(4i))))));
let _e828 = (bitcast<i32>(_e88) - 1i);
let _e830 = select(_e828, _e826, (_e826 < _e828));
let _e836 = global_2.member[bitcast<u32>(select(0i, _e830, (_e830 > 0i)))];
let _e838 = (_e802 & 15i);
let _e841 = ((_e803 & 15i) * _e797);
let _e843 = (bitcast<i32>(_e836) + ((_e804 & 15i) * _e801));
let _e847 = (_e841 + _e797);
let _e849 = (_e841 + (2i * _e797));
let _e851 = (_e841 + (3i * _e797));
let _e852 = (_e843 + _e801);
let _e854 = (_e843 + (2i * _e801));
let _e856 = (_e843 + (3i * _e801));
local_4 = type_28(array<i32, 4>(_e838, (_e838 + 1i), (_e838 + 2i), (_e838 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_5 = vec3<f32>((_e728 - f32(_e763)), (_e738 - f32(_e778)), (_e748 - f32(_e793)));
let _e867 = (_e852 + _e847);
let _e870 = local_4.member[0u];
let _e871 = (_e867 + _e870);
let _e873 = select(_e828, _e871, (_e871 < _e828));
let _e878 = global_2.member[bitcast<u32>(select(0i, _e873, (_e873 > 0i)))];
let _e879 = bitcast<f32>(_e878);
let _e882 = local_4.member[1u];
let _e883 = (_e867 + _e882);
let _e885 = select(_e828, _e883, (_e883 < _e828));
let _e890 = global_2.member[bitcast<u32>(select(0i, _e885, (_e885 > 0i)))];
let _e891 = bitcast<f32>(_e890);
let _e894 = local_4.member[2u];
let _e895 = (_e867 + _e894);
let _e897 = select(_e828, _e895, (_e895 < _e828));
let _e902 = global_2.member[bitcast<u32>(select(0i, _e897, (_e897 > 0i)))];
let _e903 = bitcast<f32>(_e902);
let _e906 = local_4.member[3u];
let _e907 = (_e867 + _e906);
let _e909 = select(_e828, _e907, (_e907 < _e828));
let _e914 = global_2.member[bitcast<u32>(select(0i, _e909, (_e909 > 0i)))];
let _e916 = local_5[0u];
let _e919 = (_e879 + ((_e891 - _e879) * _e916));
let _e920 = local_5[0u];
let _e923 = (_e891 + ((_e903 - _e891) * _e920));
let _e924 = local_5[0u];
let _e927 = (_e903 + ((bitcast<f32>(_e914) - _e903) * _e924));
let _e928 = (_e852 + _e849);
let _e929 = local_4.member[0u];
let _e930 = (_e928 + _e929);
let _e932 = select(_e828, _e930, (_e930 < _e828));
let _e937 = global_2.member[bitcast<u32>(select(0i, _e932, (_e932 > 0i)))];
let _e938 = bitcast<f32>(_e937);
let _e939 = local_4.member[1u];
let _e940 = (_e928 + _e939);
let _e942 = select(_e828, _e940, (_e940 < _e828));
let _e947 = global_2.member[bitcast<u32>(select(0i, _e942, (_e942 > 0i)))];
let _e948 = bitcast<f32>(_e947);
let _e949 = local_4.member[2u];
let _e950 = (_e928 + _e949);
let _e952 = select(_e828, _e950, (_e950 < _e828));
let _e957 = global_2.member[bitcast<u32>(select(0i, _e952, (_e952 > 0i)))];
let _e958 = bitcast<f32>(_e957);
let _e959 = local_4.member[3u];
let _e960 = (_e928 + _e959);
let _e962 = select(_e828, _e960, (_e960 < _e828));
let _e967 = global_2.member[bitcast<u32>(select(0i, _e962, (_e962 > 0i)))];
let _e969 = local_5[0u];
let _e973 = local_5[0u];
let _e976 = (_e948 + ((_e958 - _e948) * _e973));
let _e977 = local_5[0u];
let _e981 = (_e854 + _e847);
let _e982 = local_4.member[0u];
let _e983 = (_e981 + _e982);
let _e985 = select(_e828, _e983, (_e983 < _e828));
let _e990 = global_2.member[bitcast<u32>(select(0i, _e985, (_e985 > 0i)))];
let _e991 = bitcast<f32>(_e990);
let _e992 = local_4.member[1u];
let _e993 = (_e981 + _e992);
let _e995 = select(_e828, _e993, (_e993 < _e828));
let _e1000 = global_2.member[bitcast<u32>(select(0i, _e995, (_e995 > 0i)))];
let _e1001 = bitcast<f32>(_e1000);
let _e1002 = local_4.member[2u];
let _e1003 = (_e981 + _e1002);
let _e1005 = select(_e828, _e1003, (_e1003 < _e828));
let _e1010 = global_2.member[bitcast<u32>(select(0i, _e1005, (_e1005 > 0i)))];
let _e1011 = bitcast<f32>(_e1010);
let _e1012 = local_4.member[3u];
let _e1013 = (_e981 + _e1012);
let _e1015 = select(_e828, _e1013, (_e1013 < _e828));
let _e1020 = global_2.member[bitcast<u32>(select(0i, _e1015, (_e1015 > 0i)))];
let _e1022 = local_5[0u];
let _e1025 = (_e991 + ((_e1001 - _e991) * _e1022));
let _e1026 = local_5[0u];
let _e1029 = (_e1001 + ((_e1011 - _e1001) * _e1026));
let _e1030 = local_5[0u];
let _e1033 = (_e1011 + ((bitcast<f32>(_e1020) - _e1011) * _e1030));
let _e1034 = (_e854 + _e849);
let _e1035 = local_4.member[0u];
let _e1036 = (_e1034 + _e1035);
let _e1038 = select(_e828, _e1036, (_e1036 < _e828));
let _e1043 = global_2.member[bitcast<u32>(select(0i, _e1038, (_e1038 > 0i)))];
let _e1044 = bitcast<f32>(_e1043);
let _e1045 = local_4.member[1u];
let _e1046 = (_e1034 + _e1045);
let _e1048 = select(_e828, _e1046, (_e1046 < _e828));
let _e1053 = global_2.member[bitcast<u32>(select(0i, _e1048, (_e1048 > 0i)))];
let _e1054 = bitcast<f32>(_e1053);
let _e1055 = local_4.member[2u];
let _e1056 = (_e1034 + _e1055);
let _e1058 = select(_e828, _e1056, (_e1056 < _e828));
let _e1063 = global_2.member[bitcast<u32>(select(0i, _e1058, (_e1058 > 0i)))];
let _e1064 = bitcast<f32>(_e1063);
let _e1065 = local_4.member[3u];
let _e1066 = (_e1034 + _e1065);
let _e1068 = select(_e828, _e1066, (_e1066 < _e828));
let _e1073 = global_2.member[bitcast<u32>(select(0i, _e1068, (_e1068 > 0i)))];
let _e1075 = local_5[0u];
let _e1079 = local_5[0u];
let _e1082 = (_e1054 + ((_e1064 - _e1054) * _e1079));
let _e1083 = local_5[0u];
let _e1087 = (_e852 + _e841);
let _e1088 = local_4.member[1u];
let _e1089 = (_e1087 + _e1088);
let _e1091 = select(_e828, _e1089, (_e1089 < _e828));
let _e1096 = global_2.member[bitcast<u32>(select(0i, _e1091, (_e1091 > 0i)))];
let _e1097 = bitcast<f32>(_e1096);
let _e1098 = local_4.member[2u];
let _e1099 = (_e1087 + _e1098);
let _e1101 = select(_e828, _e1099, (_e1099 < _e828));
let _e1106 = global_2.member[bitcast<u32>(select(0i, _e1101, (_e1101 > 0i)))];
let _e1108 = local_5[0u];
let _e1111 = (_e1097 + ((bitcast<f32>(_e1106) - _e1097) * _e1108));
let _e1112 = (_e852 + _e851);
let _e1113 = local_4.member[1u];
let _e1114 = (_e1112 + _e1113);
let _e1116 = select(_e828, _e1114, (_e1114 < _e828));
let _e1121 = global_2.member[bitcast<u32>(select(0i, _e1116, (_e1116 > 0i)))];
let _e1122 = bitcast<f32>(_e1121);
let _e1123 = local_4.member[2u];
let _e1124 = (_e1112 + _e1123);
let _e1126 = select(_e828, _e1124, (_e1124 < _e828));
let _e1131 = global_2.member[bitcast<u32>(select(0i, _e1126, (_e1126 > 0i)))];
let _e1133 = local_5[0u];
let _e1137 = (_e854 + _e841);
let _e1138 = local_4.member[1u];
let _e1139 = (_e1137 + _e1138);
let _e1141 = select(_e828, _e1139, (_e1139 < _e828));
let _e1146 = global_2.member[bitcast<u32>(select(0i, _e1141, (_e1141 > 0i)))];
let _e1147 = bitcast<f32>(_e1146);
let _e1148 = local_4.member[2u];
let _e1149 = (_e1137 + _e1148);
let _e1151 = select(_e828, _e1149, (_e1149 < _e828));
let _e1156 = global_2.member[bitcast<u32>(select(0i, _e1151, (_e1151 > 0i)))];
let _e1158 = local_5[0u];
let _e1161 = (_e1147 + ((bitcast<f32>(_e1156) - _e1147) * _e1158));
let _e1162 = (_e854 + _e851);
let _e1163 = local_4.member[1u];
let _e1164 = (_e1162 + _e1163);
let _e1166 = select(_e828, _e1164, (_e1164 < _e828));
let _e1171 = global_2.member[bitcast<u32>(select(0i, _e1166, (_e1166 > 0i)))];
let _e1172 = bitcast<f32>(_e1171);
let _e1173 = local_4.member[2u];
let _e1174 = (_e1162 + _e1173);
let _e1176 = select(_e828, _e1174, (_e1174 < _e828));
let _e1181 = global_2.member[bitcast<u32>(select(0i, _e1176, (_e1176 > 0i)))];
let _e1183 = local_5[0u];
let _e1187 = (_e843 + _e847);
let _e1188 = local_4.member[1u];
let _e1189 = (_e1187 + _e1188);
let _e1191 = select(_e828, _e1189, (_e1189 < _e828));
let _e1196 = global_2.member[bitcast<u32>(select(0i, _e1191, (_e1191 > 0i)))];
let _e1197 = bitcast<f32>(_e1196);
let _e1198 = local_4.member[2u];
let _e1199 = (_e1187 + _e1198);
let _e1201 = select(_e828, _e1199, (_e1199 < _e828));
let _e1206 = global_2.member[bitcast<u32>(select(0i, _e1201, (_e1201 > 0i)))];
let _e1208 = local_5[0u];
let _e1211 = (_e1197 + ((bitcast<f32>(_e1206) - _e1197) * _e1208));
let _e1212 = (_e856 + _e847);
let _e1213 = local_4.member[1u];
let _e1214 = (_e1212 + _e1213);
let _e1216 = select(_e828, _e1214, (_e1214 < _e828));
let _e1221 = global_2.member[bitcast<u32>(select(0i, _e1216, (_e1216 > 0i)))];
let _e1222 = bitcast<f32>(_e1221);
let _e1223 = local_4.member[2u];
let _e1224 = (_e1212 + _e1223);
let _e1226 = select(_e828, _e1224, (_e1224 < _e828));
let _e1231 = global_2.member[bitcast<u32>(select(0i, _e1226, (_e1226 > 0i)))];
let _e1233 = local_5[0u];
let _e1236 = (_e1222 + ((bitcast<f32>(_e1231) - _e1222) * _e1233));
let _e1237 = (_e843 + _e849);
let _e1238 = local_4.member[1u];
let _e1239 = (_e1237 + _e1238);
let _e1241 = select(_e828, _e1239, (_e1239 < _e828));
let _e1246 = global_2.member[bitcast<u32>(select(0i, _e1241, (_e1241 > 0i)))];
let _e1247 = bitcast<f32>(_e1246);
let _e1248 = local_4.member[2u];
let _e1249 = (_e1237 + _e1248);
let _e1251 = select(_e828, _e1249, (_e1249 < _e828));
let _e1256 = global_2.member[bitcast<u32>(select(0i, _e1251, (_e1251 > 0i)))];
let _e1258 = local_5[0u];
let _e1262 = (_e856 + _e849);
let _e1263 = local_4.member[1u];
let _e1264 = (_e1262 + _e1263);
let _e1266 = select(_e828, _e1264, (_e1264 < _e828));
let _e1271 = global_2.member[bitcast<u32>(select(0i, _e1266, (_e1266 > 0i)))];
let _e1272 = bitcast<f32>(_e1271);
let _e1273 = local_4.member[2u];
let _e1274 = (_e1262 + _e1273);
let _e1276 = select(_e828, _e1274, (_e1274 < _e828));
let _e1281 = global_2.member[bitcast<u32>(select(0i, _e1276, (_e1276 > 0i)))];
let _e1283 = local_5[0u];
let _e1288 = local_5[1u];
let _e1291 = (_e923 + ((_e976 - _e923) * _e1288));
let _e1292 = local_5[1u];
let _e1295 = (_e1029 + ((_e1082 - _e1029) * _e1292));
let _e1296 = local_5[1u];
let _e1299 = (_e919 + (((_e938 + ((_e948 - _e938) * _e969)) - _e919) * _e1296));
let _e1300 = local_5[1u];
let _e1305 = local_5[2u];
let _e1309 = local_5[1u];
let _e1312 = (_e927 + (((_e958 + ((bitcast<f32>(_e967) - _e958) * _e977)) - _e927) * _e1309));
let _e1313 = local_5[1u];
let _e1317 = local_5[2u];
let _e1321 = local_5[1u];
let _e1324 = (_e1111 + ((_e923 - _e1111) * _e1321));
let _e1325 = local_5[1u];
let _e1329 = local_5[2u];
let _e1333 = local_5[1u];
let _e1336 = (_e976 + (((_e1122 + ((bitcast<f32>(_e1131) - _e1122) * _e1133)) - _e976) * _e1333));
let _e1337 = local_5[1u];
let _e1341 = local_5[2u];
let _e1345 = local_5[1u];
let _e1348 = (_e1211 + (((_e1247 + ((bitcast<f32>(_e1256) - _e1247) * _e1258)) - _e1211) * _e1345));
let _e1349 = local_5[2u];
let _e1353 = local_5[1u];
let _e1357 = local_5[2u];
let _e1361 = local_5[2u];
let _e1368 = global_1.member.member_6.member_5;
let _e1373 = global_1.member.member_6.member_6;
let _e1374 = (((_e1291 + ((_e1295 - _e1291) * _e1361)) * _e1368) + _e1373);
let _e1376 = select(0f, _e1374, (_e1374 > 0f));
let _e1378 = select(1f, _e1376, (_e1376 < 1f));
let _e1380 = (((_e1299 + (((_e1025 + (((_e1044 + ((_e1054 - _e1044) * _e1075)) - _e1025) * _e1300)) - _e1299) * _e1305)) * _e1368) + _e1373);
let _e1382 = select(0f, _e1380, (_e1380 > 0f));
let _e1384 = select(1f, _e1382, (_e1382 < 1f));
let _e1386 = (((_e1312 + (((_e1033 + (((_e1064 + ((bitcast<f32>(_e1073) - _e1064) * _e1083)) - _e1033) * _e1313)) - _e1312) * _e1317)) * _e1368) + _e1373);
let _e1388 = select(0f, _e1386, (_e1386 > 0f));
let _e1390 = select(1f, _e1388, (_e1388 < 1f));
let _e1392 = (((_e1324 + (((_e1161 + ((_e1029 - _e1161) * _e1325)) - _e1324) * _e1329)) * _e1368) + _e1373);
let _e1394 = select(0f, _e1392, (_e1392 > 0f));
let _e1396 = select(1f, _e1394, (_e1394 < 1f));
let _e1398 = (((_e1336 + (((_e1082 + (((_e1172 + ((bitcast<f32>(_e1181) - _e1172) * _e1183)) - _e1082) * _e1337)) - _e1336) * _e1341)) * _e1368) + _e1373);
let _e1400 = select(0f, _e1398, (_e1398 > 0f));
let _e1402 = select(1f, _e1400, (_e1400 < 1f));
let _e1404 = (((_e1348 + ((_e1291 - _e1348) * _e1349)) * _e1368) + _e1373);
let _e1406 = select(0f, _e1404, (_e1404 > 0f));
let _e1408 = select(1f, _e1406, (_e1406 < 1f));
let _e1410 = (((_e1295 + (((_e1236 + (((_e1272 + ((bitcast<f32>(_e1281) - _e1272) * _e1283)) - _e1236) * _e1353)) - _e1295) * _e1357)) * _e1368) + _e1373);
let _e1412 = select(0f, _e1410, (_e1410 > 0f));
let _e1414 = select(1f, _e1412, (_e1412 < 1f));
let _e1415 = (_e1378 * 1024f);
let _e1416 = (1024f - 1f);
let _e1418 = select(0f, _e1415, (_e1415 > 0f));
let _e1420 = select(_e1416, _e1418, (_e1418 < _e1416));
let _e1427 = select(0i, select(select(i32(_e1420), i32(-2147483648), (_e1420 < -2147483600f)), 2147483647i, (_e1420 > 2147483500f)), (_e1420 == _e1420));
let _e1431 = (_e1427 - select(0i, 1i, (_e1420 < f32(_e1427))));
let _e1432 = (262147i + _e1431);
let _e1434 = (bitcast<i32>(_e92) - 1i);
let _e1436 = select(_e1434, _e1432, (_e1432 < _e1434));
let _e1442 = global_4.member[bitcast<u32>(select(0i, _e1436, (_e1436 > 0i)))];
let _e1452 = select(_e1434, 262146i, (262146i < _e1434));
let _e1458 = global_4.member[bitcast<u32>(select(0i, _e1452, (_e1452 > 0i)))];
let _e1459 = bitcast<f32>(_e1458);
let _e1460 = (f32((bitcast<i32>((_e1442 & 4095u)) - 2048i)) * _e1459);
let _e1462 = select(_e1434, 262144i, (262144i < _e1434));
let _e1468 = global_4.member[bitcast<u32>(select(0i, _e1462, (_e1462 > 0i)))];
let _e1469 = bitcast<f32>(_e1468);
let _e1471 = select(_e1434, 262145i, (262145i < _e1434));
let _e1477 = global_4.member[bitcast<u32>(select(0i, _e1471, (_e1471 > 0i)))];
let _e1478 = bitcast<f32>(_e1477);
let _e1484 = ((_e1469 + (f32(bitcast<i32>((_e1442 >> bitcast<u32>(12u)))) * _e1478)) + (_e1460 * (_e1415 - f32(_e1431))));
let _e1485 = (_e1460 * 1024f);
if _e715 {
let _e1492 = ((0.5f * (_e1390 - _e1384)) * _e1485);
let _e1493 = ((0.5f * (_e1402 - _e1396)) * _e1485);
let _e1494 = ((0.5f * (_e1414 - _e1408)) * _e1485);
phi_3132_ = type_29(_e1484, vec3<f32>(_e1492, _e1493, _e1494), vec3<f32>((_e1492 * _e1484), (_e1493 * _e1484), (_e1494 * _e1484)));
} else {
let _e1501 = (_e1384 * 1024f);
let _e1503 = select(0f, _e1501, (_e1501 > 0f));
let _e1505 = select(_e1416, _e1503, (_e1503 < _e1416));
let _e1512 = select(0i, select(select(i32(_e1505), i32(-2147483648), (_e1505 < -2147483600f)), 2147483647i, (_e1505 > 2147483500f)), (_e1505 == _e1505));
let _e1516 = (_e1512 - select(0i, 1i, (_e1505 < f32(_e1512))));
let _e1517 = (262147i + _e1516);
let _e1519 = select(_e1434, _e1517, (_e1517 < _e1434));
let _e1525 = global_4.member[bitcast<u32>(select(0i, _e1519, (_e1519 > 0i)))];
let _e1540 = ((_e1469 + (f32(bitcast<i32>((_e1525 >> bitcast<u32>(12u)))) * _e1478)) + ((f32((bitcast<i32>((_e1525 & 4095u)) - 2048i)) * _e1459) * (_e1501 - f32(_e1516))));
let _e1541 = (_e1390 * 1024f);
let _e1543 = select(0f, _e1541, (_e1541 > 0f));
let _e1545 = select(_e1416, _e1543, (_e1543 < _e1416));
let _e1552 = select(0i, select(select(i32(_e1545), i32(-2147483648), (_e1545 < -2147483600f)), 2147483647i, (_e1545 > 2147483500f)), (_e1545 == _e1545));
let _e1556 = (_e1552 - select(0i, 1i, (_e1545 < f32(_e1552))));
let _e1557 = (262147i + _e1556);
let _e1559 = select(_e1434, _e1557, (_e1557 < _e1434));
let _e1565 = global_4.member[bitcast<u32>(select(0i, _e1559, (_e1559 > 0i)))];
let _e1580 = ((_e1469 + (f32(bitcast<i32>((_e1565 >> bitcast<u32>(12u)))) * _e1478)) + ((f32((bitcast<i32>((_e1565 & 4095u)) - 2048i)) * _e1459) * (_e1541 - f32(_e1556))));
let _e1581 = (_e1396 * 1024f);
let _e1583 = select(0f, _e1581, (_e1581 > 0f));
let _e1585 = select(_e1416, _e1583, (_e1583 < _e1416));
let _e1592 = select(0i, select(select(i32(_e1585), i32(-2147483648), (_e1585 < -2147483600f)), 2147483647i, (_e1585 > 2147483500f)), (_e1585 == _e1585));
let _e1596 = (_e1592 - select(0i, 1i, (_e1585 < f32(_e1592))));
let _e1597 = (262147i + _e1596);
let _e1599 = select(_e1434, _e1597, (_e1597 < _e1434));
let _e1605 = global_4.member[bitcast<u32>(select(0i, _e1599, (_e1599 > 0i)))];
let _e1620 = ((_e1469 + (f32(bitcast<i32>((_e1605 >> bitcast<u32>(12u)))) * _e1478)) + ((f32((bitcast<i32>((_e1605 & 4095u)) - 2048i)) * _e1459) * (_e1581 - f32(_e1596))));
let _e1621 = (_e1402 * 1024f);
let _e1623 = select(0f, _e1621, (_e1621 > 0f));
let _e1625 = select(_e1416, _e1623, (_e1623 < _e1416));
let _e1632 = select(0i, select(select(i32(_e1625), i32(-2147483648), (_e1625 < -2147483600f)), 2147483647i, (_e1625 > 2147483500f)), (_e1625 == _e1625));
let _e1636 = (_e1632 - select(0i, 1i, (_e1625 < f32(_e1632))));
let _e1637 = (262147i + _e1636);
let _e1639 = select(_e1434, _e1637, (_e1637 < _e1434));
let _e1645 = global_4.member[bitcast<u32>(select(0i, _e1639, (_e1639 > 0i)))];
let _e1660 = ((_e1469 + (f32(bitcast<i32>((_e1645 >> bitcast<u32>(12u)))) * _e1478)) + ((f32((bitcast<i32>((_e1645 & 4095u)) - 2048i)) * _e1459) * (_e1621 - f32(_e1636))));
let _e1661 = (_e1408 * 1024f);
let _e1663 = select(0f, _e1661, (_e1661 > 0f));
let _e1665 = select(_e1416, _e1663, (_e1663 < _e1416));
let _e1672 = select(0i, select(select(i32(_e1665), i32(-2147483648), (_e1665 < -2147483600f)), 2147483647i, (_e1665 > 2147483500f)), (_e1665 == _e1665));
let _e1676 = (_e1672 - select(0i, 1i, (_e1665 < f32(_e1672))));
let _e1677 = (262147i + _e1676);
let _e1679 = select(_e1434, _e1677, (_e1677 < _e1434));
let _e1685 = global_4.member[bitcast<u32>(select(0i, _e1679, (_e1679 > 0i)))];
let _e1700 = ((_e1469 + (f32(bitcast<i32>((_e1685 >> bitcast<u32>(12u)))) * _e1478)) + ((f32((bitcast<i32>((_e1685 & 4095u)) - 2048i)) * _e1459) * (_e1661 - f32(_e1676))));
let _e1701 = (_e1414 * 1024f);
let _e1703 = select(0f, _e1701, (_e1701 > 0f));
let _e1705 = select(_e1416, _e1703, (_e1703 < _e1416));
let _e1712 = select(0i, select(select(i32(_e1705), i32(-2147483648), (_e1705 < -2147483600f)), 2147483647i, (_e1705 > 2147483500f)), (_e1705 == _e1705));
let _e1716 = (_e1712 - select(0i, 1i, (_e1705 < f32(_e1712))));
let _e1717 = (262147i + _e1716);
let _e1719 = select(_e1434, _e1717, (_e1717 < _e1434));
let _e1725 = global_4.member[bitcast<u32>(select(0i, _e1719, (_e1719 > 0i)))];
let _e1740 = ((_e1469 + (f32(bitcast<i32>((_e1725 >> bitcast<u32>(12u)))) * _e1478)) + ((f32((bitcast<i32>((_e1725 & 4095u)) - 2048i)) * _e1459) * (_e1701 - f32(_e1716))));
let _e1741 = (_e1580 - _e1540);
let _e1743 = (_e1660 - _e1620);
let _e1745 = (_e1740 - _e1700);
phi_3132_ = type_29(_e1484, vec3<f32>((0.5f * _e1741), (0.5f * _e1743), (0.5f * _e1745)), vec3<f32>((0.25f * (_e1741 * (_e1580 + _e1540))), (0.25f * (_e1743 * (_e1660 + _e1620))), (0.25f * (_e1745 * (_e1740 + _e1700)))));
}
let _e1760 = phi_3132_;
let _e1775 = select(0f, 1f, ((((((_e701 >= -0.5f) && (_e701 <= _e724)) && (_e707 >= -0.5f)) && (_e707 <= _e734)) && (_e713 >= -0.5f)) && (_e713 <= _e744)));
let _e1777 = (0.5f * (_e1390 - _e1384));
let _e1779 = (0.5f * (_e1402 - _e1396));
let _e1781 = (0.5f * (_e1414 - _e1408));
let _e1787 = global_1.member.member_6.member.member.member;
let _e1793 = global_1.member.member_6.member.member.member_1;
let _e1799 = global_1.member.member_6.member.member.member_2;
let _e1805 = global_1.member.member_6.member_1.member.member;
let _e1811 = global_1.member.member_6.member_1.member.member_1;
let _e1817 = global_1.member.member_6.member_1.member.member_2;
let _e1823 = global_1.member.member_6.member_2.member.member;
let _e1829 = global_1.member.member_6.member_2.member.member_1;
let _e1835 = global_1.member.member_6.member_2.member.member_2;
phi_3741_ = type_30(_e1378, vec3<f32>(((((_e1787 * _e1777) + (_e1805 * _e1779)) + (_e1823 * _e1781)) * _e1775), ((((_e1793 * _e1777) + (_e1811 * _e1779)) + (_e1829 * _e1781)) * _e1775), ((((_e1799 * _e1777) + (_e1817 * _e1779)) + (_e1835 * _e1781)) * _e1775)), _e1760.member, vec3<f32>(((((_e1787 * _e1760.member_2.x) + (_e1805 * _e1760.member_2.y)) + (_e1823 * _e1760.member_2.z)) * _e1775), ((((_e1793 * _e1760.member_2.x) + (_e1811 * _e1760.member_2.y)) + (_e1829 * _e1760.member_2.z)) * _e1775), ((((_e1799 * _e1760.member_2.x) + (_e1817 * _e1760.member_2.y)) + (_e1835 * _e1760.member_2.z)) * _e1775)), vec3<f32>(((((_e1787 * _e1760.member_1.x) + (_e1805 * _e1760.member_1.y)) + (_e1823 * _e1760.member_1.z)) * _e1775), ((((_e1793 * _e1760.member_1.x) + (_e1811 * _e1760.member_1.y)) + (_e1829 * _e1760.member_1.z)) * _e1775), ((((_e1799 * _e1760.member_1.x) + (_e1817 * _e1760.member_1.y)) + (_e1835 * _e1760.member_1.z)) * _e1775)));
} else {
let _e1904 = global_1.member.member_6.member_3.member;
let _e1905 = (_e1904 - 0.5f);
let _e1907 = select(-0.5f, _e701, (_e701 > -0.5f));
let _e1909 = select(_e1905, _e1907, (_e1907 < _e1905));
let _e1914 = global_1.member.member_6.member_3.member_1;
let _e1915 = (_e1914 - 0.5f);
let _e1917 = select(-0.5f, _e707, (_e707 > -0.5f));
let _e1919 = select(_e1915, _e1917, (_e1917 < _e1915));
let _e1924 = global_1.member.member_6.member_3.member_2;
let _e1925 = (_e1924 - 0.5f);
let _e1927 = select(-0.5f, _e713, (_e713 > -0.5f));
let _e1929 = select(_e1925, _e1927, (_e1927 < _e1925));
let _e1931 = select(-1f, _e1909, (_e1909 > -1f));
let _e1933 = select(_e1904, _e1931, (_e1931 < _e1904));
let _e1940 = select(0i, select(select(i32(_e1933), i32(-2147483648), (_e1933 < -2147483600f)), 2147483647i, (_e1933 > 2147483500f)), (_e1933 == _e1933));
let _e1944 = (_e1940 - select(0i, 1i, (_e1933 < f32(_e1940))));
let _e1946 = select(-1f, _e1919, (_e1919 > -1f));
let _e1948 = select(_e1914, _e1946, (_e1946 < _e1914));
let _e1955 = select(0i, select(select(i32(_e1948), i32(-2147483648), (_e1948 < -2147483600f)), 2147483647i, (_e1948 > 2147483500f)), (_e1948 == _e1948));
let _e1959 = (_e1955 - select(0i, 1i, (_e1948 < f32(_e1955))));
let _e1961 = select(-1f, _e1929, (_e1929 > -1f));
let _e1963 = select(_e1924, _e1961, (_e1961 < _e1924));
let _e1970 = select(0i, select(select(i32(_e1963), i32(-2147483648), (_e1963 < -2147483600f)), 2147483647i, (_e1963 > 2147483500f)), (_e1963 == _e1963));
let _e1974 = (_e1970 - select(0i, 1i, (_e1963 < f32(_e1970))));
let _e1978 = global_1.member.member_6.member_7;
let _e1982 = global_1.member.member_6.member_8;
let _e1983 = (_e1944 + 1i);
let _e1984 = (_e1959 + 1i);
let _e1985 = (_e1974 + 1i);
let _e1990 = global_1.member.member_6.member_11.member;
let _e1996 = global_1.member.member_6.member_11.member_1;
let _e2007 = ((_e1983 >> bitcast<u32>(4i)) + (bitcast<i32>(_e1990) * ((_e1984 >> bitcast<u32>(4i)) + (bitcast<i32>(_e1996) * (_e1985 >> bitcast<u32>(4i))))));
let _e2009 = (bitcast<i32>(_e88) - 1i);
let _e2011 = select(_e2009, _e2007, (_e2007 < _e2009));
let _e2017 = global_2.member[bitcast<u32>(select(0i, _e2011, (_e2011 > 0i)))];
let _e2019 = (_e1983 & 15i);
let _e2022 = ((_e1984 & 15i) * _e1978);
let _e2024 = (bitcast<i32>(_e2017) + ((_e1985 & 15i) * _e1982));
let _e2028 = (_e2022 + _e1978);
let _e2030 = (_e2022 + (2i * _e1978));
let _e2031 = (_e2024 + _e1982);
let _e2033 = (_e2024 + (2i * _e1982));
local_2 = type_28(array<i32, 4>(_e2019, (_e2019 + 1i), (_e2019 + 2i), (_e2019 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_3 = vec3<f32>((_e1909 - f32(_e1944)), (_e1919 - f32(_e1959)), (_e1929 - f32(_e1974)));
let _e2044 = (_e2031 + _e2028);
let _e2047 = local_2.member[1u];
let _e2048 = (_e2044 + _e2047);
let _e2050 = select(_e2009, _e2048, (_e2048 < _e2009));
let _e2055 = global_2.member[bitcast<u32>(select(0i, _e2050, (_e2050 > 0i)))];
let _e2056 = bitcast<f32>(_e2055);
let _e2059 = local_2.member[2u];
let _e2060 = (_e2044 + _e2059);
let _e2062 = select(_e2009, _e2060, (_e2060 < _e2009));
let _e2067 = global_2.member[bitcast<u32>(select(0i, _e2062, (_e2062 > 0i)))];
let _e2069 = local_3[0u];
let _e2072 = (_e2056 + ((bitcast<f32>(_e2067) - _e2056) * _e2069));
let _e2073 = (_e2031 + _e2030);
let _e2074 = local_2.member[1u];
let _e2075 = (_e2073 + _e2074);
let _e2077 = select(_e2009, _e2075, (_e2075 < _e2009));
let _e2082 = global_2.member[bitcast<u32>(select(0i, _e2077, (_e2077 > 0i)))];
let _e2083 = bitcast<f32>(_e2082);
let _e2084 = local_2.member[2u];
let _e2085 = (_e2073 + _e2084);
let _e2087 = select(_e2009, _e2085, (_e2085 < _e2009));
let _e2092 = global_2.member[bitcast<u32>(select(0i, _e2087, (_e2087 > 0i)))];
let _e2094 = local_3[0u];
let _e2099 = local_3[1u];
let _e2102 = (_e2072 + (((_e2083 + ((bitcast<f32>(_e2092) - _e2083) * _e2094)) - _e2072) * _e2099));
let _e2103 = (_e2033 + _e2028);
let _e2104 = local_2.member[1u];
let _e2105 = (_e2103 + _e2104);
let _e2107 = select(_e2009, _e2105, (_e2105 < _e2009));
let _e2112 = global_2.member[bitcast<u32>(select(0i, _e2107, (_e2107 > 0i)))];
let _e2113 = bitcast<f32>(_e2112);
let _e2114 = local_2.member[2u];
let _e2115 = (_e2103 + _e2114);
let _e2117 = select(_e2009, _e2115, (_e2115 < _e2009));
let _e2122 = global_2.member[bitcast<u32>(select(0i, _e2117, (_e2117 > 0i)))];
let _e2124 = local_3[0u];
let _e2127 = (_e2113 + ((bitcast<f32>(_e2122) - _e2113) * _e2124));
let _e2128 = (_e2033 + _e2030);
let _e2129 = local_2.member[1u];
let _e2130 = (_e2128 + _e2129);
let _e2132 = select(_e2009, _e2130, (_e2130 < _e2009));
let _e2137 = global_2.member[bitcast<u32>(select(0i, _e2132, (_e2132 > 0i)))];
let _e2138 = bitcast<f32>(_e2137);
let _e2139 = local_2.member[2u];
let _e2140 = (_e2128 + _e2139);
let _e2142 = select(_e2009, _e2140, (_e2140 < _e2009));
let _e2147 = global_2.member[bitcast<u32>(select(0i, _e2142, (_e2142 > 0i)))];
let _e2149 = local_3[0u];
let _e2153 = local_3[1u];
let _e2158 = local_3[2u];
let _e2165 = global_1.member.member_6.member_5;
let _e2170 = global_1.member.member_6.member_6;
let _e2171 = (((_e2102 + (((_e2127 + (((_e2138 + ((bitcast<f32>(_e2147) - _e2138) * _e2149)) - _e2127) * _e2153)) - _e2102) * _e2158)) * _e2165) + _e2170);
let _e2173 = select(0f, _e2171, (_e2171 > 0f));
phi_3741_ = type_30(select(1f, _e2173, (_e2173 < 1f)), vec3<f32>(0f, 0f, 0f), 1f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
}
let _e2178 = phi_3741_;
let _e2183 = global_1.member.member_6.member_3.member;
let _e2184 = (_e2183 - 0.5f);
let _e2186 = select(-0.5f, _e665, (_e665 > -0.5f));
let _e2188 = select(_e2184, _e2186, (_e2186 < _e2184));
let _e2193 = global_1.member.member_6.member_3.member_1;
let _e2194 = (_e2193 - 0.5f);
let _e2196 = select(-0.5f, _e680, (_e680 > -0.5f));
let _e2198 = select(_e2194, _e2196, (_e2196 < _e2194));
let _e2203 = global_1.member.member_6.member_3.member_2;
let _e2204 = (_e2203 - 0.5f);
let _e2206 = select(-0.5f, _e695, (_e695 > -0.5f));
let _e2208 = select(_e2204, _e2206, (_e2206 < _e2204));
let _e2210 = select(-1f, _e2188, (_e2188 > -1f));
let _e2212 = select(_e2183, _e2210, (_e2210 < _e2183));
let _e2219 = select(0i, select(select(i32(_e2212), i32(-2147483648), (_e2212 < -2147483600f)), 2147483647i, (_e2212 > 2147483500f)), (_e2212 == _e2212));
let _e2223 = (_e2219 - select(0i, 1i, (_e2212 < f32(_e2219))));
let _e2225 = select(-1f, _e2198, (_e2198 > -1f));
let _e2227 = select(_e2193, _e2225, (_e2225 < _e2193));
let _e2234 = select(0i, select(select(i32(_e2227), i32(-2147483648), (_e2227 < -2147483600f)), 2147483647i, (_e2227 > 2147483500f)), (_e2227 == _e2227));
let _e2238 = (_e2234 - select(0i, 1i, (_e2227 < f32(_e2234))));
let _e2240 = select(-1f, _e2208, (_e2208 > -1f));
let _e2242 = select(_e2203, _e2240, (_e2240 < _e2203));
let _e2249 = select(0i, select(select(i32(_e2242), i32(-2147483648), (_e2242 < -2147483600f)), 2147483647i, (_e2242 > 2147483500f)), (_e2242 == _e2242));
let _e2253 = (_e2249 - select(0i, 1i, (_e2242 < f32(_e2249))));
let _e2257 = global_1.member.member_6.member_7;
let _e2261 = global_1.member.member_6.member_8;
let _e2262 = (_e2223 + 1i);
let _e2263 = (_e2238 + 1i);
let _e2264 = (_e2253 + 1i);
let _e2269 = global_1.member.member_6.member_11.member;
let _e2275 = global_1.member.member_6.member_11.member_1;
let _e2286 = ((_e2262 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2269) * ((_e2263 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2275) * (_e2264 >> bitcast<u32>(4i))))));
let _e2288 = (bitcast<i32>(_e88) - 1i);
let _e2290 = select(_e2288, _e2286, (_e2286 < _e2288));
let _e2296 = global_2.member[bitcast<u32>(select(0i, _e2290, (_e2290 > 0i)))];
let _e2298 = (_e2262 & 15i);
let _e2301 = ((_e2263 & 15i) * _e2257);
let _e2303 = (bitcast<i32>(_e2296) + ((_e2264 & 15i) * _e2261));
let _e2307 = (_e2301 + _e2257);
let _e2309 = (_e2301 + (2i * _e2257));
let _e2310 = (_e2303 + _e2261);
let _e2312 = (_e2303 + (2i * _e2261));
local = type_28(array<i32, 4>(_e2298, (_e2298 + 1i), (_e2298 + 2i), (_e2298 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_1 = vec3<f32>((_e2188 - f32(_e2223)), (_e2198 - f32(_e2238)), (_e2208 - f32(_e2253)));
let _e2323 = (_e2310 + _e2307);
let _e2326 = local.member[1u];
let _e2327 = (_e2323 + _e2326);
let _e2329 = select(_e2288, _e2327, (_e2327 < _e2288));
let _e2334 = global_2.member[bitcast<u32>(select(0i, _e2329, (_e2329 > 0i)))];
let _e2335 = bitcast<f32>(_e2334);
let _e2338 = local.member[2u];
let _e2339 = (_e2323 + _e2338);
let _e2341 = select(_e2288, _e2339, (_e2339 < _e2288));
let _e2346 = global_2.member[bitcast<u32>(select(0i, _e2341, (_e2341 > 0i)))];
let _e2348 = local_1[0u];
let _e2351 = (_e2335 + ((bitcast<f32>(_e2346) - _e2335) * _e2348));
let _e2352 = (_e2310 + _e2309);
let _e2353 = local.member[1u];
let _e2354 = (_e2352 + _e2353);
let _e2356 = select(_e2288, _e2354, (_e2354 < _e2288));
let _e2361 = global_2.member[bitcast<u32>(select(0i, _e2356, (_e2356 > 0i)))];
let _e2362 = bitcast<f32>(_e2361);
let _e2363 = local.member[2u];
let _e2364 = (_e2352 + _e2363);
let _e2366 = select(_e2288, _e2364, (_e2364 < _e2288));
let _e2371 = global_2.member[bitcast<u32>(select(0i, _e2366, (_e2366 > 0i)))];
let _e2373 = local_1[0u];
let _e2378 = local_1[1u];
let _e2381 = (_e2351 + (((_e2362 + ((bitcast<f32>(_e2371) - _e2362) * _e2373)) - _e2351) * _e2378));
let _e2382 = (_e2312 + _e2307);
let _e2383 = local.member[1u];
let _e2384 = (_e2382 + _e2383);
let _e2386 = select(_e2288, _e2384, (_e2384 < _e2288));
let _e2391 = global_2.member[bitcast<u32>(select(0i, _e2386, (_e2386 > 0i)))];
let _e2392 = bitcast<f32>(_e2391);
let _e2393 = local.member[2u];
let _e2394 = (_e2382 + _e2393);
let _e2396 = select(_e2288, _e2394, (_e2394 < _e2288));
let _e2401 = global_2.member[bitcast<u32>(select(0i, _e2396, (_e2396 > 0i)))];
let _e2403 = local_1[0u];
let _e2406 = (_e2392 + ((bitcast<f32>(_e2401) - _e2392) * _e2403));
let _e2407 = (_e2312 + _e2309);
let _e2408 = local.member[1u];
let _e2409 = (_e2407 + _e2408);
let _e2411 = select(_e2288, _e2409, (_e2409 < _e2288));
let _e2416 = global_2.member[bitcast<u32>(select(0i, _e2411, (_e2411 > 0i)))];
let _e2417 = bitcast<f32>(_e2416);
let _e2418 = local.member[2u];
let _e2419 = (_e2407 + _e2418);
let _e2421 = select(_e2288, _e2419, (_e2419 < _e2288));
let _e2426 = global_2.member[bitcast<u32>(select(0i, _e2421, (_e2421 > 0i)))];
let _e2428 = local_1[0u];
let _e2432 = local_1[1u];
let _e2437 = local_1[2u];
let _e2444 = global_1.member.member_6.member_5;
let _e2449 = global_1.member.member_6.member_6;
let _e2450 = (((_e2381 + (((_e2406 + (((_e2417 + ((bitcast<f32>(_e2426) - _e2417) * _e2428)) - _e2406) * _e2432)) - _e2381) * _e2437)) * _e2444) + _e2449);
let _e2452 = select(0f, _e2450, (_e2450 > 0f));
let _e2454 = select(1f, _e2452, (_e2452 < 1f));
let _e2457 = global_1.member.member_1;
if ((_e2457 & 16u) == 0u) {
phi_4537_ = type_5(1f, 1f, 1f);
} else {
let _e2463 = global_1.member.member_14.member;
let _e2474 = ((((_e2463.member.member * _e622) + (_e2463.member.member_1 * _e635)) + (_e2463.member.member_2 * _e600)) + _e2463.member_1);
let _e2480 = ((((_e2463.member.member * _e645) + (_e2463.member.member_1 * _e650)) + (_e2463.member.member_2 * _e639)) + _e2463.member_1);
let _e2482 = select(_e2480, _e2474, (_e2474 < _e2480));
let _e2484 = select(_e2480, _e2474, (_e2474 > _e2480));
let _e2486 = (_e2484 - _e2482);
let _e2489 = (-(_e2482) / select(1e-30f, _e2486, (_e2486 > 1e-30f)));
let _e2491 = select(0f, _e2489, (_e2489 > 0f));
let _e2497 = select(select(select(1f, _e2491, (_e2491 < 1f)), 1f, (_e2484 <= 0f)), 0f, (_e2482 > 0f));
let _e2502 = global_1.member.member_14.member_1;
let _e2503 = (_e2502 != 0u);
let _e2513 = global_1.member.member_15.member;
let _e2524 = ((((_e2513.member.member * _e622) + (_e2513.member.member_1 * _e635)) + (_e2513.member.member_2 * _e600)) + _e2513.member_1);
let _e2530 = ((((_e2513.member.member * _e645) + (_e2513.member.member_1 * _e650)) + (_e2513.member.member_2 * _e639)) + _e2513.member_1);
let _e2532 = select(_e2530, _e2524, (_e2524 < _e2530));
let _e2534 = select(_e2530, _e2524, (_e2524 > _e2530));
let _e2536 = (_e2534 - _e2532);
let _e2539 = (-(_e2532) / select(1e-30f, _e2536, (_e2536 > 1e-30f)));
let _e2541 = select(0f, _e2539, (_e2539 > 0f));
let _e2547 = select(select(select(1f, _e2541, (_e2541 < 1f)), 1f, (_e2534 <= 0f)), 0f, (_e2532 > 0f));
let _e2552 = global_1.member.member_15.member_1;
let _e2553 = (_e2552 != 0u);
let _e2563 = global_1.member.member_16.member;
let _e2574 = ((((_e2563.member.member * _e622) + (_e2563.member.member_1 * _e635)) + (_e2563.member.member_2 * _e600)) + _e2563.member_1);
let _e2580 = ((((_e2563.member.member * _e645) + (_e2563.member.member_1 * _e650)) + (_e2563.member.member_2 * _e639)) + _e2563.member_1);
let _e2582 = select(_e2580, _e2574, (_e2574 < _e2580));
let _e2584 = select(_e2580, _e2574, (_e2574 > _e2580));
let _e2586 = (_e2584 - _e2582);
let _e2589 = (-(_e2582) / select(1e-30f, _e2586, (_e2586 > 1e-30f)));
let _e2591 = select(0f, _e2589, (_e2589 > 0f));
let _e2597 = select(select(select(1f, _e2591, (_e2591 < 1f)), 1f, (_e2584 <= 0f)), 0f, (_e2582 > 0f));
let _e2602 = global_1.member.member_16.member_1;
let _e2603 = (_e2602 != 0u);
let _e2613 = global_1.member.member_17.member;
let _e2624 = ((((_e2613.member.member * _e622) + (_e2613.member.member_1 * _e635)) + (_e2613.member.member_2 * _e600)) + _e2613.member_1);
let _e2630 = ((((_e2613.member.member * _e645) + (_e2613.member.member_1 * _e650)) + (_e2613.member.member_2 * _e639)) + _e2613.member_1);
let _e2632 = select(_e2630, _e2624, (_e2624 < _e2630));
let _e2634 = select(_e2630, _e2624, (_e2624 > _e2630));
let _e2636 = (_e2634 - _e2632);
let _e2639 = (-(_e2632) / select(1e-30f, _e2636, (_e2636 > 1e-30f)));
let _e2641 = select(0f, _e2639, (_e2639 > 0f));
let _e2647 = select(select(select(1f, _e2641, (_e2641 < 1f)), 1f, (_e2634 <= 0f)), 0f, (_e2632 > 0f));
let _e2652 = global_1.member.member_17.member_1;
let _e2653 = (_e2652 != 0u);
phi_4537_ = type_5(((((1f * _e2497) * _e2547) * _e2597) * _e2647), ((((1f * select(1f, _e2497, _e2503)) * select(1f, _e2547, _e2553)) * select(1f, _e2597, _e2603)) * select(1f, _e2647, _e2653)), ((((1f * select(1f, 0f, (_e2503 && (_e2480 > 0f)))) * select(1f, 0f, (_e2553 && (_e2530 > 0f)))) * select(1f, 0f, (_e2603 && (_e2580 > 0f)))) * select(1f, 0f, (_e2653 && (_e2630 > 0f)))));
}
let _e2662 = phi_4537_;
let _e2663 = (_e701 - _e665);
let _e2667 = (bitcast<f32>((bitcast<u32>(_e2663) & 2147483647u)) < 1e-12f);
let _e2669 = (1f / select(_e2663, 1f, _e2667));
let _e2671 = ((-0.5f - _e665) * _e2669);
let _e2673 = ((_e2184 - _e665) * _e2669);
let _e2679 = select(_e2673, _e2671, (_e2671 < _e2673));
let _e2681 = select(0f, _e2679, (_e2679 > 0f));
let _e2684 = select(select(1f, _e2681, (_e2681 < 1f)), select(2f, 0f, ((_e665 >= -0.5f) && (_e665 <= _e2184))), _e2667);
let _e2686 = select(_e2673, _e2671, (_e2671 > _e2673));
let _e2688 = select(0f, _e2686, (_e2686 > 0f));
let _e2691 = select(select(1f, _e2688, (_e2688 < 1f)), 1f, _e2667);
let _e2692 = (_e707 - _e680);
let _e2696 = (bitcast<f32>((bitcast<u32>(_e2692) & 2147483647u)) < 1e-12f);
let _e2698 = (1f / select(_e2692, 1f, _e2696));
let _e2700 = ((-0.5f - _e680) * _e2698);
let _e2702 = ((_e2194 - _e680) * _e2698);
let _e2708 = select(_e2702, _e2700, (_e2700 < _e2702));
let _e2710 = select(0f, _e2708, (_e2708 > 0f));
let _e2713 = select(select(1f, _e2710, (_e2710 < 1f)), select(2f, 0f, ((_e680 >= -0.5f) && (_e680 <= _e2194))), _e2696);
let _e2715 = select(_e2702, _e2700, (_e2700 > _e2702));
let _e2717 = select(0f, _e2715, (_e2715 > 0f));
let _e2720 = select(select(1f, _e2717, (_e2717 < 1f)), 1f, _e2696);
let _e2721 = (_e713 - _e695);
let _e2725 = (bitcast<f32>((bitcast<u32>(_e2721) & 2147483647u)) < 1e-12f);
let _e2727 = (1f / select(_e2721, 1f, _e2725));
let _e2729 = ((-0.5f - _e695) * _e2727);
let _e2731 = ((_e2204 - _e695) * _e2727);
let _e2737 = select(_e2731, _e2729, (_e2729 < _e2731));
let _e2739 = select(0f, _e2737, (_e2737 > 0f));
let _e2742 = select(select(1f, _e2739, (_e2739 < 1f)), select(2f, 0f, ((_e695 >= -0.5f) && (_e695 <= _e2204))), _e2725);
let _e2744 = select(_e2731, _e2729, (_e2729 > _e2731));
let _e2746 = select(0f, _e2744, (_e2744 > 0f));
let _e2749 = select(select(1f, _e2746, (_e2746 < 1f)), 1f, _e2725);
let _e2751 = select(_e2720, _e2691, (_e2691 < _e2720));
let _e2755 = select(_e2713, _e2684, (_e2684 > _e2713));
let _e2758 = (select(_e2749, _e2751, (_e2751 < _e2749)) - select(_e2742, _e2755, (_e2755 > _e2742)));
let _e2761 = (_e645 - _e622);
let _e2762 = (_e650 - _e635);
let _e2763 = (_e639 - _e600);
let _e2768 = (((_e2761 * _e2761) + (_e2762 * _e2762)) + (_e2763 * _e2763));
let _e2776 = global_1.member.member_5.member_3;
let _e2777 = ((sqrt(select(0f, _e2768, (_e2768 > 0f))) * select(0f, _e2758, (_e2758 > 0f))) * _e2776);
if (_e102.member_2 >= 3u) {
let _e2780 = (_e2454 * 255f);
let _e2781 = (_e2178.member * 255f);
let _e2782 = (255f - 1f);
let _e2784 = select(0f, _e2780, (_e2780 > 0f));
let _e2786 = select(_e2782, _e2784, (_e2784 < _e2782));
let _e2793 = select(0i, select(select(i32(_e2786), i32(-2147483648), (_e2786 < -2147483600f)), 2147483647i, (_e2786 > 2147483500f)), (_e2786 == _e2786));
let _e2797 = (_e2793 - select(0i, 1i, (_e2786 < f32(_e2793))));
let _e2799 = select(0f, _e2781, (_e2781 > 0f));
let _e2801 = select(_e2782, _e2799, (_e2799 < _e2782));
let _e2808 = select(0i, select(select(i32(_e2801), i32(-2147483648), (_e2801 < -2147483600f)), 2147483647i, (_e2801 > 2147483500f)), (_e2801 == _e2801));
let _e2812 = (_e2808 - select(0i, 1i, (_e2801 < f32(_e2808))));
let _e2815 = (((_e2797 * 256i) + _e2812) * 4i);
let _e2819 = (_e2781 - f32(_e2812));
let _e2821 = (bitcast<i32>(_e92) - 1i);
let _e2823 = select(_e2821, _e2815, (_e2815 < _e2821));
let _e2829 = global_4.member[bitcast<u32>(select(0i, _e2823, (_e2823 > 0i)))];
let _e2830 = (_e2815 + 4i);
let _e2832 = select(_e2821, _e2830, (_e2830 < _e2821));
let _e2838 = global_4.member[bitcast<u32>(select(0i, _e2832, (_e2832 > 0i)))];
let _e2839 = (_e2815 + 1024i);
let _e2841 = select(_e2821, _e2839, (_e2839 < _e2821));
let _e2847 = global_4.member[bitcast<u32>(select(0i, _e2841, (_e2841 > 0i)))];
let _e2848 = (_e2815 + 1028i);
let _e2850 = select(_e2821, _e2848, (_e2848 < _e2821));
let _e2856 = global_4.member[bitcast<u32>(select(0i, _e2850, (_e2850 > 0i)))];
let _e2861 = (bitcast<f32>(((_e2829 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e2869 = (_e2861 + (((bitcast<f32>(((_e2838 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e2861) * _e2819));
let _e2874 = (bitcast<f32>(((_e2847 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e2885 = (_e2869 + (((_e2874 + (((bitcast<f32>(((_e2856 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e2874) * _e2819)) - _e2869) * (_e2780 - f32(_e2797))));
let _e2889 = -((_e2885 * (_e2777 * _e2662.member)));
let _e2891 = select(-87f, _e2889, (_e2889 > -87f));
let _e2893 = select(88f, _e2891, (_e2891 < 88f));
let _e2895 = ((_e2893 * 1.442695f) + 0.5f);
let _e2897 = select(-127f, _e2895, (_e2895 > -127f));
let _e2899 = select(128f, _e2897, (_e2897 < 128f));
let _e2906 = select(0i, select(select(i32(_e2899), i32(-2147483648), (_e2899 < -2147483600f)), 2147483647i, (_e2899 > 2147483500f)), (_e2899 == _e2899));
let _e2910 = (_e2906 - select(0i, 1i, (_e2899 < f32(_e2906))));
let _e2911 = f32(_e2910);
let _e2915 = ((_e2893 - (_e2911 * 0.6933594f)) - (_e2911 * -2.1219444e-4f));
let _e2935 = ((1f + (_e2915 * (1f + (_e2915 * (0.5f + (_e2915 * (0.16666667f + (_e2915 * (0.041666668f + (_e2915 * (0.008333334f + (_e2915 * (0.001388889f + (_e2915 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2910 + 127i)) << bitcast<u32>(23i))));
let _e2936 = (1f - _e2935);
phi_5647_ = type_31(_e2935, _e2936, vec3<f32>(1f, 1f, 1f), vec3((0f * (_e2936 / select(1e-12f, _e2885, (_e2885 > 1e-12f))))));
} else {
let _e2944 = (_e2454 * 255f);
let _e2945 = (_e2178.member * 255f);
let _e2946 = (255f - 1f);
let _e2948 = select(0f, _e2944, (_e2944 > 0f));
let _e2950 = select(_e2946, _e2948, (_e2948 < _e2946));
let _e2957 = select(0i, select(select(i32(_e2950), i32(-2147483648), (_e2950 < -2147483600f)), 2147483647i, (_e2950 > 2147483500f)), (_e2950 == _e2950));
let _e2961 = (_e2957 - select(0i, 1i, (_e2950 < f32(_e2957))));
let _e2963 = select(0f, _e2945, (_e2945 > 0f));
let _e2965 = select(_e2946, _e2963, (_e2963 < _e2946));
let _e2972 = select(0i, select(select(i32(_e2965), i32(-2147483648), (_e2965 < -2147483600f)), 2147483647i, (_e2965 > 2147483500f)), (_e2965 == _e2965));
let _e2976 = (_e2972 - select(0i, 1i, (_e2965 < f32(_e2972))));
let _e2979 = (((_e2961 * 256i) + _e2976) * 4i);
let _e2981 = (_e2944 - f32(_e2961));
let _e2983 = (_e2945 - f32(_e2976));
let _e2985 = (bitcast<i32>(_e92) - 1i);
let _e2987 = select(_e2985, _e2979, (_e2979 < _e2985));
let _e2993 = global_4.member[bitcast<u32>(select(0i, _e2987, (_e2987 > 0i)))];
let _e2994 = (_e2979 + 4i);
let _e2996 = select(_e2985, _e2994, (_e2994 < _e2985));
let _e3002 = global_4.member[bitcast<u32>(select(0i, _e2996, (_e2996 > 0i)))];
let _e3003 = (_e2979 + 1024i);
let _e3005 = select(_e2985, _e3003, (_e3003 < _e2985));
let _e3011 = global_4.member[bitcast<u32>(select(0i, _e3005, (_e3005 > 0i)))];
let _e3012 = (_e2979 + 1028i);
let _e3014 = select(_e2985, _e3012, (_e3012 < _e2985));
let _e3020 = global_4.member[bitcast<u32>(select(0i, _e3014, (_e3014 > 0i)))];
let _e3025 = (bitcast<f32>(((_e2993 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3033 = (_e3025 + (((bitcast<f32>(((_e3002 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3025) * _e2983));
let _e3038 = (bitcast<f32>(((_e3011 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3049 = (_e3033 + (((_e3038 + (((bitcast<f32>(((_e3020 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3038) * _e2983)) - _e3033) * _e2981));
let _e3062 = (bitcast<f32>((((_e2993 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3070 = (_e3062 + (((bitcast<f32>((((_e3002 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3062) * _e2983));
let _e3075 = (bitcast<f32>((((_e3011 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3087 = (_e2979 + 1i);
let _e3089 = select(_e2985, _e3087, (_e3087 < _e2985));
let _e3095 = global_4.member[bitcast<u32>(select(0i, _e3089, (_e3089 > 0i)))];
let _e3096 = (_e2979 + 5i);
let _e3098 = select(_e2985, _e3096, (_e3096 < _e2985));
let _e3104 = global_4.member[bitcast<u32>(select(0i, _e3098, (_e3098 > 0i)))];
let _e3105 = (_e2979 + 1025i);
let _e3107 = select(_e2985, _e3105, (_e3105 < _e2985));
let _e3113 = global_4.member[bitcast<u32>(select(0i, _e3107, (_e3107 > 0i)))];
let _e3114 = (_e2979 + 1029i);
let _e3116 = select(_e2985, _e3114, (_e3114 < _e2985));
let _e3122 = global_4.member[bitcast<u32>(select(0i, _e3116, (_e3116 > 0i)))];
let _e3127 = (bitcast<f32>(((_e3095 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3135 = (_e3127 + (((bitcast<f32>(((_e3104 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3127) * _e2983));
let _e3140 = (bitcast<f32>(((_e3113 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3164 = (bitcast<f32>((((_e3095 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3172 = (_e3164 + (((bitcast<f32>((((_e3104 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3164) * _e2983));
let _e3177 = (bitcast<f32>((((_e3113 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3192 = (_e2777 * _e2662.member_1);
let _e3194 = -(((_e3070 + (((_e3075 + (((bitcast<f32>((((_e3020 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3075) * _e2983)) - _e3070) * _e2981)) * _e3192));
let _e3196 = select(-87f, _e3194, (_e3194 > -87f));
let _e3198 = select(88f, _e3196, (_e3196 < 88f));
let _e3200 = ((_e3198 * 1.442695f) + 0.5f);
let _e3202 = select(-127f, _e3200, (_e3200 > -127f));
let _e3204 = select(128f, _e3202, (_e3202 < 128f));
let _e3211 = select(0i, select(select(i32(_e3204), i32(-2147483648), (_e3204 < -2147483600f)), 2147483647i, (_e3204 > 2147483500f)), (_e3204 == _e3204));
let _e3215 = (_e3211 - select(0i, 1i, (_e3204 < f32(_e3211))));
let _e3216 = f32(_e3215);
let _e3220 = ((_e3198 - (_e3216 * 0.6933594f)) - (_e3216 * -2.1219444e-4f));
let _e3242 = -(((_e3135 + (((_e3140 + (((bitcast<f32>(((_e3122 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3140) * _e2983)) - _e3135) * _e2981)) * _e3192));
let _e3244 = select(-87f, _e3242, (_e3242 > -87f));
let _e3246 = select(88f, _e3244, (_e3244 < 88f));
let _e3248 = ((_e3246 * 1.442695f) + 0.5f);
let _e3250 = select(-127f, _e3248, (_e3248 > -127f));
let _e3252 = select(128f, _e3250, (_e3250 < 128f));
let _e3259 = select(0i, select(select(i32(_e3252), i32(-2147483648), (_e3252 < -2147483600f)), 2147483647i, (_e3252 > 2147483500f)), (_e3252 == _e3252));
let _e3263 = (_e3259 - select(0i, 1i, (_e3252 < f32(_e3259))));
let _e3264 = f32(_e3263);
let _e3268 = ((_e3246 - (_e3264 * 0.6933594f)) - (_e3264 * -2.1219444e-4f));
let _e3290 = -(((_e3172 + (((_e3177 + (((bitcast<f32>((((_e3122 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3177) * _e2983)) - _e3172) * _e2981)) * _e3192));
let _e3292 = select(-87f, _e3290, (_e3290 > -87f));
let _e3294 = select(88f, _e3292, (_e3292 < 88f));
let _e3296 = ((_e3294 * 1.442695f) + 0.5f);
let _e3298 = select(-127f, _e3296, (_e3296 > -127f));
let _e3300 = select(128f, _e3298, (_e3298 < 128f));
let _e3307 = select(0i, select(select(i32(_e3300), i32(-2147483648), (_e3300 < -2147483600f)), 2147483647i, (_e3300 > 2147483500f)), (_e3300 == _e3300));
let _e3311 = (_e3307 - select(0i, 1i, (_e3300 < f32(_e3307))));
let _e3312 = f32(_e3311);
let _e3316 = ((_e3294 - (_e3312 * 0.6933594f)) - (_e3312 * -2.1219444e-4f));
let _e3339 = -((_e3049 * (_e2777 * _e2662.member)));
let _e3341 = select(-87f, _e3339, (_e3339 > -87f));
let _e3343 = select(88f, _e3341, (_e3341 < 88f));
let _e3345 = ((_e3343 * 1.442695f) + 0.5f);
let _e3347 = select(-127f, _e3345, (_e3345 > -127f));
let _e3349 = select(128f, _e3347, (_e3347 < 128f));
let _e3356 = select(0i, select(select(i32(_e3349), i32(-2147483648), (_e3349 < -2147483600f)), 2147483647i, (_e3349 > 2147483500f)), (_e3349 == _e3349));
let _e3360 = (_e3356 - select(0i, 1i, (_e3349 < f32(_e3356))));
let _e3361 = f32(_e3360);
let _e3365 = ((_e3343 - (_e3361 * 0.6933594f)) - (_e3361 * -2.1219444e-4f));
let _e3385 = ((1f + (_e3365 * (1f + (_e3365 * (0.5f + (_e3365 * (0.16666667f + (_e3365 * (0.041666668f + (_e3365 * (0.008333334f + (_e3365 * (0.001388889f + (_e3365 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3360 + 127i)) << bitcast<u32>(23i))));
let _e3386 = (1f - _e3385);
phi_5647_ = type_31(_e3385, _e3386, vec3<f32>(((1f + (_e3220 * (1f + (_e3220 * (0.5f + (_e3220 * (0.16666667f + (_e3220 * (0.041666668f + (_e3220 * (0.008333334f + (_e3220 * (0.001388889f + (_e3220 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3215 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e3268 * (1f + (_e3268 * (0.5f + (_e3268 * (0.16666667f + (_e3268 * (0.041666668f + (_e3268 * (0.008333334f + (_e3268 * (0.001388889f + (_e3268 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3263 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e3316 * (1f + (_e3316 * (0.5f + (_e3316 * (0.16666667f + (_e3316 * (0.041666668f + (_e3316 * (0.008333334f + (_e3316 * (0.001388889f + (_e3316 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3311 + 127i)) << bitcast<u32>(23i))))), vec3((0f * (_e3386 / select(1e-12f, _e3049, (_e3049 > 1e-12f))))));
}
let _e3394 = phi_5647_;
if _e718 {
let _e3398 = global_1.member.member_5.member_2;
let _e3406 = global_1.member.member_5.member_4;
let _e3409 = (_e2178.member_3.x * _e2662.member_2);
let _e3411 = (_e2178.member_3.y * _e2662.member_2);
let _e3413 = (_e2178.member_3.z * _e2662.member_2);
let _e3414 = (0.5f * (_e3398 / select(1e-6f, _e182, (_e182 > 1e-6f))));
let _e3418 = (_e160 + (_e3409 * _e3414));
let _e3419 = (_e171 + (_e3411 * _e3414));
let _e3420 = (_e182 + (_e3413 * _e3414));
let _e3422 = (2f * _e3398);
let _e3424 = ((_e3420 * _e3420) + (_e3422 * _e3413));
let _e3428 = (_e3420 + sqrt(select(0f, _e3424, (_e3424 > 0f))));
let _e3432 = (0.5f * (_e3422 / select(1e-6f, _e3428, (_e3428 > 1e-6f))));
let _e3436 = (_e3418 + (_e3409 * _e3432));
let _e3437 = (_e3419 + (_e3411 * _e3432));
let _e3438 = (_e3420 + (_e3413 * _e3432));
let _e3442 = (_e3406 * _e3406);
let _e3444 = (_e3438 * _e3438);
let _e3452 = (((_e3420 <= 0f) || (_e3424 <= 0f)) || ((_e3438 <= 0f) || (_e3444 <= (_e3442 * (((_e3436 * _e3436) + (_e3437 * _e3437)) + _e3444)))));
let _e3466 = (_e160 + ((_e2178.member_4.x * _e2662.member_2) * _e3398));
let _e3467 = (_e171 + ((_e2178.member_4.y * _e2662.member_2) * _e3398));
let _e3468 = (_e182 + ((_e2178.member_4.z * _e2662.member_2) * _e3398));
let _e3470 = (_e3468 * _e3468);
let _e3479 = ((_e2457 & 1u) != 0u);
let _e3483 = select(_e3452, ((_e3468 <= 0f) || (_e3470 <= (_e3442 * (((_e3466 * _e3466) + (_e3467 * _e3467)) + _e3470)))), _e3479);
phi_5798_ = select(select(select(_e3438, _e3420, _e3452), _e3468, _e3479), _e182, _e3483);
phi_5799_ = select(select(select(_e3437, _e3419, _e3452), _e3467, _e3479), _e171, _e3483);
phi_5800_ = select(select(select(_e3436, _e3418, _e3452), _e3466, _e3479), _e160, _e3483);
phi_5801_ = select(1f, 0f, _e3483);
} else {
phi_5798_ = _e182;
phi_5799_ = _e171;
phi_5800_ = _e160;
phi_5801_ = 1f;
}
let _e3489 = phi_5798_;
let _e3491 = phi_5799_;
let _e3493 = phi_5800_;
let _e3495 = phi_5801_;
let _e3498 = (_e3394.member * _e3495);
global_5.member[_e117] = (_e128 * (_e3394.member_2.x * _e3498));
global_5.member[_e129] = (_e138 * (_e3394.member_2.y * _e3498));
global_5.member[_e140] = (_e149 * (_e3394.member_2.z * _e3498));
global_5.member[_e151] = _e3493;
global_5.member[_e162] = _e3491;
global_5.member[_e173] = _e3489;
global_5.member[_e184] = _e193;
global_5.member[_e195] = _e204;
global_5.member[_e206] = _e215;
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
