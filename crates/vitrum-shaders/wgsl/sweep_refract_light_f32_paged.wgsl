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
var phi_941_: u32;
var phi_3135_: type_29;
var phi_3744_: type_30;
var phi_4540_: type_5;
var phi_5650_: type_31;
var phi_5802_: vec3<f32>;
var phi_5803_: f32;
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
phi_941_ = select(select(7u, 3u, (((((((_e315 >= 0f) && (_e315 <= _e370)) && (_e330 >= 0f)) && (_e330 <= _e380)) && (_e345 >= 0f)) && (_e345 <= _e390)) && ((((((_e351 >= 0f) && (_e351 <= _e370)) && (_e357 >= 0f)) && (_e357 <= _e380)) && (_e363 >= 0f)) && (_e363 <= _e390)))), 1u, (((_e555 & 64u) != 0u) || ((((select(_e438, _e435, (_e435 > _e438)) <= _e409) && ((select(_e455, _e452, (_e452 > _e455)) > _e409) || (_e549 != 0u))) && true) && ((_e555 & 32u) != 0u))));
} else {
phi_941_ = 7u;
}
let _e565 = phi_941_;
if (_e565 > 1u) {
let _e571 = bitcast<i32>(((_e112 * _e219) + _e110));
let _e574 = (bitcast<i32>(_e94) - 1i);
let _e576 = select(_e574, _e571, (_e571 < _e574));
let _e582 = global_6.member[bitcast<u32>(select(0i, _e576, (_e576 > 0i)))];
let _e583 = (bitcast<i32>(_e224) + _e571);
let _e585 = select(_e574, _e583, (_e583 < _e574));
let _e591 = global_6.member[bitcast<u32>(select(0i, _e585, (_e585 > 0i)))];
let _e593 = f32(bitcast<i32>(_e110));
let _e595 = f32(bitcast<i32>(_e112));
let _e601 = global_1.member.member_5.member;
let _e605 = global_1.member.member_8.member_8;
let _e606 = (_e601 - _e605);
let _e610 = global_1.member.member_8.member_2;
let _e614 = global_1.member.member_8.member_6;
let _e621 = global_1.member.member_8.member_4;
let _e623 = ((_e610 + (_e614 * _e606)) + (((_e593 - _e582) + 0.5f) * _e621));
let _e627 = global_1.member.member_8.member_3;
let _e631 = global_1.member.member_8.member_7;
let _e636 = ((_e627 + (_e631 * _e606)) + (((_e595 - _e591) + 0.5f) * _e621));
let _e640 = global_1.member.member_5.member_1;
let _e641 = (_e640 - _e605);
let _e646 = ((_e610 + (_e614 * _e641)) + ((_e593 + 0.5f) * _e621));
let _e651 = ((_e627 + (_e631 * _e641)) + ((_e595 + 0.5f) * _e621));
let _e655 = global_1.member.member_6.member;
let _e666 = ((((_e655.member.member * _e623) + (_e655.member.member_1 * _e636)) + (_e655.member.member_2 * _e601)) + _e655.member_1);
let _e670 = global_1.member.member_6.member_1;
let _e681 = ((((_e670.member.member * _e623) + (_e670.member.member_1 * _e636)) + (_e670.member.member_2 * _e601)) + _e670.member_1);
let _e685 = global_1.member.member_6.member_2;
let _e696 = ((((_e685.member.member * _e623) + (_e685.member.member_1 * _e636)) + (_e685.member.member_2 * _e601)) + _e685.member_1);
let _e702 = ((((_e655.member.member * _e646) + (_e655.member.member_1 * _e651)) + (_e655.member.member_2 * _e640)) + _e655.member_1);
let _e708 = ((((_e670.member.member * _e646) + (_e670.member.member_1 * _e651)) + (_e670.member.member_2 * _e640)) + _e670.member_1);
let _e714 = ((((_e685.member.member * _e646) + (_e685.member.member_1 * _e651)) + (_e685.member.member_2 * _e640)) + _e685.member_1);
let _e716 = (_e102.member_2 == 2u);
let _e719 = (((_e102.member_2 == 1u) || _e716) || (_e102.member_2 == 5u));
if _e719 {
let _e724 = global_1.member.member_6.member_3.member;
let _e725 = (_e724 - 0.5f);
let _e727 = select(-0.5f, _e702, (_e702 > -0.5f));
let _e729 = select(_e725, _e727, (_e727 < _e725));
let _e734 = global_1.member.member_6.member_3.member_1;
let _e735 = (_e734 - 0.5f);
let _e737 = select(-0.5f, _e708, (_e708 > -0.5f));
let _e739 = select(_e735, _e737, (_e737 < _e735));
let _e744 = global_1.member.member_6.member_3.member_2;
let _e745 = (_e744 - 0.5f);
let _e747 = select(-0.5f, _e714, (_e714 > -0.5f));
let _e749 = select(_e745, _e747, (_e747 < _e745));
let _e751 = select(-1f, _e729, (_e729 > -1f));
let _e753 = select(_e724, _e751, (_e751 < _e724));
let _e760 = select(0i, select(select(i32(_e753), i32(-2147483648), (_e753 < -2147483600f)), 2147483647i, (_e753 > 2147483500f)), (_e753 == _e753));
let _e764 = (_e760 - select(0i, 1i, (_e753 < f32(_e760))));
let _e766 = select(-1f, _e739, (_e739 > -1f));
let _e768 = select(_e734, _e766, (_e766 < _e734));
let _e775 = select(0i, select(select(i32(_e768), i32(-2147483648), (_e768 < -2147483600f)), 2147483647i, (_e768 > 2147483500f)), (_e768 == _e768));
let _e779 = (_e775 - select(0i, 1i, (_e768 < f32(_e775))));
let _e781 = select(-1f, _e749, (_e749 > -1f));
let _e783 = select(_e744, _e781, (_e781 < _e744));
let _e790 = select(0i, select(select(i32(_e783), i32(-2147483648), (_e783 < -2147483600f)), 2147483647i, (_e783 > 2147483500f)), (_e783 == _e783));
let _e794 = (_e790 - select(0i, 1i, (_e783 < f32(_e790))));
let _e798 = global_1.member.member_6.member_7;
let _e802 = global_1.member.member_6.member_8;
let _e803 = (_e764 + 1i);
let _e804 = (_e779 + 1i);
let _e805 = (_e794 + 1i);
let _e810 = global_1.member.member_6.member_11.member;
let _e816 = global_1.member.member_6.member_11.member_1;
let _e827 = ((_e803 >> bitcast<u32>(4i)) + (bitcast<i32>(_e810) * ((_e804 >> bitcast<u32>(4i)) + (bitcast<i32>(_e816) * (_e805 >> bitcast<u32>(4i))))));
let _e829 = (bitcast<i32>(_e88) - 1i);
let _e831 = select(_e829, _e827, (_e827 < _e829));
let _e837 = global_2.member[bitcast<u32>(select(0i, _e831, (_e831 > 0i)))];
let _e839 = (_e803 & 15i);
let _e842 = ((_e804 & 15i) * _e798);
let _e844 = (bitcast<i32>(_e837) + ((_e805 & 15i) * _e802));
let _e848 = (_e842 + _e798);
let _e850 = (_e842 + (2i * _e798));
let _e852 = (_e842 + (3i * _e798));
let _e853 = (_e844 + _e802);
let _e855 = (_e844 + (2i * _e802));
let _e857 = (_e844 + (3i * _e802));
local_4 = type_28(array<i32, 4>(_e839, (_e839 + 1i), (_e839 + 2i), (_e839 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_5 = vec3<f32>((_e729 - f32(_e764)), (_e739 - f32(_e779)), (_e749 - f32(_e794)));
let _e868 = (_e853 + _e848);
let _e871 = local_4.member[0u];
let _e872 = (_e868 + _e871);
let _e874 = select(_e829, _e872, (_e872 < _e829));
let _e879 = global_2.member[bitcast<u32>(select(0i, _e874, (_e874 > 0i)))];
let _e880 = bitcast<f32>(_e879);
let _e883 = local_4.member[1u];
let _e884 = (_e868 + _e883);
let _e886 = select(_e829, _e884, (_e884 < _e829));
let _e891 = global_2.member[bitcast<u32>(select(0i, _e886, (_e886 > 0i)))];
let _e892 = bitcast<f32>(_e891);
let _e895 = local_4.member[2u];
let _e896 = (_e868 + _e895);
let _e898 = select(_e829, _e896, (_e896 < _e829));
let _e903 = global_2.member[bitcast<u32>(select(0i, _e898, (_e898 > 0i)))];
let _e904 = bitcast<f32>(_e903);
let _e907 = local_4.member[3u];
let _e908 = (_e868 + _e907);
let _e910 = select(_e829, _e908, (_e908 < _e829));
let _e915 = global_2.member[bitcast<u32>(select(0i, _e910, (_e910 > 0i)))];
let _e917 = local_5[0u];
let _e920 = (_e880 + ((_e892 - _e880) * _e917));
let _e921 = local_5[0u];
let _e924 = (_e892 + ((_e904 - _e892) * _e921));
let _e925 = local_5[0u];
let _e928 = (_e904 + ((bitcast<f32>(_e915) - _e904) * _e925));
let _e929 = (_e853 + _e850);
let _e930 = local_4.member[0u];
let _e931 = (_e929 + _e930);
let _e933 = select(_e829, _e931, (_e931 < _e829));
let _e938 = global_2.member[bitcast<u32>(select(0i, _e933, (_e933 > 0i)))];
let _e939 = bitcast<f32>(_e938);
let _e940 = local_4.member[1u];
let _e941 = (_e929 + _e940);
let _e943 = select(_e829, _e941, (_e941 < _e829));
let _e948 = global_2.member[bitcast<u32>(select(0i, _e943, (_e943 > 0i)))];
let _e949 = bitcast<f32>(_e948);
let _e950 = local_4.member[2u];
let _e951 = (_e929 + _e950);
let _e953 = select(_e829, _e951, (_e951 < _e829));
let _e958 = global_2.member[bitcast<u32>(select(0i, _e953, (_e953 > 0i)))];
let _e959 = bitcast<f32>(_e958);
let _e960 = local_4.member[3u];
let _e961 = (_e929 + _e960);
let _e963 = select(_e829, _e961, (_e961 < _e829));
let _e968 = global_2.member[bitcast<u32>(select(0i, _e963, (_e963 > 0i)))];
let _e970 = local_5[0u];
let _e974 = local_5[0u];
let _e977 = (_e949 + ((_e959 - _e949) * _e974));
let _e978 = local_5[0u];
let _e982 = (_e855 + _e848);
let _e983 = local_4.member[0u];
let _e984 = (_e982 + _e983);
let _e986 = select(_e829, _e984, (_e984 < _e829));
let _e991 = global_2.member[bitcast<u32>(select(0i, _e986, (_e986 > 0i)))];
let _e992 = bitcast<f32>(_e991);
let _e993 = local_4.member[1u];
let _e994 = (_e982 + _e993);
let _e996 = select(_e829, _e994, (_e994 < _e829));
let _e1001 = global_2.member[bitcast<u32>(select(0i, _e996, (_e996 > 0i)))];
let _e1002 = bitcast<f32>(_e1001);
let _e1003 = local_4.member[2u];
let _e1004 = (_e982 + _e1003);
let _e1006 = select(_e829, _e1004, (_e1004 < _e829));
let _e1011 = global_2.member[bitcast<u32>(select(0i, _e1006, (_e1006 > 0i)))];
let _e1012 = bitcast<f32>(_e1011);
let _e1013 = local_4.member[3u];
let _e1014 = (_e982 + _e1013);
let _e1016 = select(_e829, _e1014, (_e1014 < _e829));
let _e1021 = global_2.member[bitcast<u32>(select(0i, _e1016, (_e1016 > 0i)))];
let _e1023 = local_5[0u];
let _e1026 = (_e992 + ((_e1002 - _e992) * _e1023));
let _e1027 = local_5[0u];
let _e1030 = (_e1002 + ((_e1012 - _e1002) * _e1027));
let _e1031 = local_5[0u];
let _e1034 = (_e1012 + ((bitcast<f32>(_e1021) - _e1012) * _e1031));
let _e1035 = (_e855 + _e850);
let _e1036 = local_4.member[0u];
let _e1037 = (_e1035 + _e1036);
let _e1039 = select(_e829, _e1037, (_e1037 < _e829));
let _e1044 = global_2.member[bitcast<u32>(select(0i, _e1039, (_e1039 > 0i)))];
let _e1045 = bitcast<f32>(_e1044);
let _e1046 = local_4.member[1u];
let _e1047 = (_e1035 + _e1046);
let _e1049 = select(_e829, _e1047, (_e1047 < _e829));
let _e1054 = global_2.member[bitcast<u32>(select(0i, _e1049, (_e1049 > 0i)))];
let _e1055 = bitcast<f32>(_e1054);
let _e1056 = local_4.member[2u];
let _e1057 = (_e1035 + _e1056);
let _e1059 = select(_e829, _e1057, (_e1057 < _e829));
let _e1064 = global_2.member[bitcast<u32>(select(0i, _e1059, (_e1059 > 0i)))];
let _e1065 = bitcast<f32>(_e1064);
let _e1066 = local_4.member[3u];
let _e1067 = (_e1035 + _e1066);
let _e1069 = select(_e829, _e1067, (_e1067 < _e829));
let _e1074 = global_2.member[bitcast<u32>(select(0i, _e1069, (_e1069 > 0i)))];
let _e1076 = local_5[0u];
let _e1080 = local_5[0u];
let _e1083 = (_e1055 + ((_e1065 - _e1055) * _e1080));
let _e1084 = local_5[0u];
let _e1088 = (_e853 + _e842);
let _e1089 = local_4.member[1u];
let _e1090 = (_e1088 + _e1089);
let _e1092 = select(_e829, _e1090, (_e1090 < _e829));
let _e1097 = global_2.member[bitcast<u32>(select(0i, _e1092, (_e1092 > 0i)))];
let _e1098 = bitcast<f32>(_e1097);
let _e1099 = local_4.member[2u];
let _e1100 = (_e1088 + _e1099);
let _e1102 = select(_e829, _e1100, (_e1100 < _e829));
let _e1107 = global_2.member[bitcast<u32>(select(0i, _e1102, (_e1102 > 0i)))];
let _e1109 = local_5[0u];
let _e1112 = (_e1098 + ((bitcast<f32>(_e1107) - _e1098) * _e1109));
let _e1113 = (_e853 + _e852);
let _e1114 = local_4.member[1u];
let _e1115 = (_e1113 + _e1114);
let _e1117 = select(_e829, _e1115, (_e1115 < _e829));
let _e1122 = global_2.member[bitcast<u32>(select(0i, _e1117, (_e1117 > 0i)))];
let _e1123 = bitcast<f32>(_e1122);
let _e1124 = local_4.member[2u];
let _e1125 = (_e1113 + _e1124);
let _e1127 = select(_e829, _e1125, (_e1125 < _e829));
let _e1132 = global_2.member[bitcast<u32>(select(0i, _e1127, (_e1127 > 0i)))];
let _e1134 = local_5[0u];
let _e1138 = (_e855 + _e842);
let _e1139 = local_4.member[1u];
let _e1140 = (_e1138 + _e1139);
let _e1142 = select(_e829, _e1140, (_e1140 < _e829));
let _e1147 = global_2.member[bitcast<u32>(select(0i, _e1142, (_e1142 > 0i)))];
let _e1148 = bitcast<f32>(_e1147);
let _e1149 = local_4.member[2u];
let _e1150 = (_e1138 + _e1149);
let _e1152 = select(_e829, _e1150, (_e1150 < _e829));
let _e1157 = global_2.member[bitcast<u32>(select(0i, _e1152, (_e1152 > 0i)))];
let _e1159 = local_5[0u];
let _e1162 = (_e1148 + ((bitcast<f32>(_e1157) - _e1148) * _e1159));
let _e1163 = (_e855 + _e852);
let _e1164 = local_4.member[1u];
let _e1165 = (_e1163 + _e1164);
let _e1167 = select(_e829, _e1165, (_e1165 < _e829));
let _e1172 = global_2.member[bitcast<u32>(select(0i, _e1167, (_e1167 > 0i)))];
let _e1173 = bitcast<f32>(_e1172);
let _e1174 = local_4.member[2u];
let _e1175 = (_e1163 + _e1174);
let _e1177 = select(_e829, _e1175, (_e1175 < _e829));
let _e1182 = global_2.member[bitcast<u32>(select(0i, _e1177, (_e1177 > 0i)))];
let _e1184 = local_5[0u];
let _e1188 = (_e844 + _e848);
let _e1189 = local_4.member[1u];
let _e1190 = (_e1188 + _e1189);
let _e1192 = select(_e829, _e1190, (_e1190 < _e829));
let _e1197 = global_2.member[bitcast<u32>(select(0i, _e1192, (_e1192 > 0i)))];
let _e1198 = bitcast<f32>(_e1197);
let _e1199 = local_4.member[2u];
let _e1200 = (_e1188 + _e1199);
let _e1202 = select(_e829, _e1200, (_e1200 < _e829));
let _e1207 = global_2.member[bitcast<u32>(select(0i, _e1202, (_e1202 > 0i)))];
let _e1209 = local_5[0u];
let _e1212 = (_e1198 + ((bitcast<f32>(_e1207) - _e1198) * _e1209));
let _e1213 = (_e857 + _e848);
let _e1214 = local_4.member[1u];
let _e1215 = (_e1213 + _e1214);
let _e1217 = select(_e829, _e1215, (_e1215 < _e829));
let _e1222 = global_2.member[bitcast<u32>(select(0i, _e1217, (_e1217 > 0i)))];
let _e1223 = bitcast<f32>(_e1222);
let _e1224 = local_4.member[2u];
let _e1225 = (_e1213 + _e1224);
let _e1227 = select(_e829, _e1225, (_e1225 < _e829));
let _e1232 = global_2.member[bitcast<u32>(select(0i, _e1227, (_e1227 > 0i)))];
let _e1234 = local_5[0u];
let _e1237 = (_e1223 + ((bitcast<f32>(_e1232) - _e1223) * _e1234));
let _e1238 = (_e844 + _e850);
let _e1239 = local_4.member[1u];
let _e1240 = (_e1238 + _e1239);
let _e1242 = select(_e829, _e1240, (_e1240 < _e829));
let _e1247 = global_2.member[bitcast<u32>(select(0i, _e1242, (_e1242 > 0i)))];
let _e1248 = bitcast<f32>(_e1247);
let _e1249 = local_4.member[2u];
let _e1250 = (_e1238 + _e1249);
let _e1252 = select(_e829, _e1250, (_e1250 < _e829));
let _e1257 = global_2.member[bitcast<u32>(select(0i, _e1252, (_e1252 > 0i)))];
let _e1259 = local_5[0u];
let _e1263 = (_e857 + _e850);
let _e1264 = local_4.member[1u];
let _e1265 = (_e1263 + _e1264);
let _e1267 = select(_e829, _e1265, (_e1265 < _e829));
let _e1272 = global_2.member[bitcast<u32>(select(0i, _e1267, (_e1267 > 0i)))];
let _e1273 = bitcast<f32>(_e1272);
let _e1274 = local_4.member[2u];
let _e1275 = (_e1263 + _e1274);
let _e1277 = select(_e829, _e1275, (_e1275 < _e829));
let _e1282 = global_2.member[bitcast<u32>(select(0i, _e1277, (_e1277 > 0i)))];
let _e1284 = local_5[0u];
let _e1289 = local_5[1u];
let _e1292 = (_e924 + ((_e977 - _e924) * _e1289));
let _e1293 = local_5[1u];
let _e1296 = (_e1030 + ((_e1083 - _e1030) * _e1293));
let _e1297 = local_5[1u];
let _e1300 = (_e920 + (((_e939 + ((_e949 - _e939) * _e970)) - _e920) * _e1297));
let _e1301 = local_5[1u];
let _e1306 = local_5[2u];
let _e1310 = local_5[1u];
let _e1313 = (_e928 + (((_e959 + ((bitcast<f32>(_e968) - _e959) * _e978)) - _e928) * _e1310));
let _e1314 = local_5[1u];
let _e1318 = local_5[2u];
let _e1322 = local_5[1u];
let _e1325 = (_e1112 + ((_e924 - _e1112) * _e1322));
let _e1326 = local_5[1u];
let _e1330 = local_5[2u];
let _e1334 = local_5[1u];
let _e1337 = (_e977 + (((_e1123 + ((bitcast<f32>(_e1132) - _e1123) * _e1134)) - _e977) * _e1334));
let _e1338 = local_5[1u];
let _e1342 = local_5[2u];
let _e1346 = local_5[1u];
let _e1349 = (_e1212 + (((_e1248 + ((bitcast<f32>(_e1257) - _e1248) * _e1259)) - _e1212) * _e1346));
let _e1350 = local_5[2u];
let _e1354 = local_5[1u];
let _e1358 = local_5[2u];
let _e1362 = local_5[2u];
let _e1369 = global_1.member.member_6.member_5;
let _e1374 = global_1.member.member_6.member_6;
let _e1375 = (((_e1292 + ((_e1296 - _e1292) * _e1362)) * _e1369) + _e1374);
let _e1377 = select(0f, _e1375, (_e1375 > 0f));
let _e1379 = select(1f, _e1377, (_e1377 < 1f));
let _e1381 = (((_e1300 + (((_e1026 + (((_e1045 + ((_e1055 - _e1045) * _e1076)) - _e1026) * _e1301)) - _e1300) * _e1306)) * _e1369) + _e1374);
let _e1383 = select(0f, _e1381, (_e1381 > 0f));
let _e1385 = select(1f, _e1383, (_e1383 < 1f));
let _e1387 = (((_e1313 + (((_e1034 + (((_e1065 + ((bitcast<f32>(_e1074) - _e1065) * _e1084)) - _e1034) * _e1314)) - _e1313) * _e1318)) * _e1369) + _e1374);
let _e1389 = select(0f, _e1387, (_e1387 > 0f));
let _e1391 = select(1f, _e1389, (_e1389 < 1f));
let _e1393 = (((_e1325 + (((_e1162 + ((_e1030 - _e1162) * _e1326)) - _e1325) * _e1330)) * _e1369) + _e1374);
let _e1395 = select(0f, _e1393, (_e1393 > 0f));
let _e1397 = select(1f, _e1395, (_e1395 < 1f));
let _e1399 = (((_e1337 + (((_e1083 + (((_e1173 + ((bitcast<f32>(_e1182) - _e1173) * _e1184)) - _e1083) * _e1338)) - _e1337) * _e1342)) * _e1369) + _e1374);
let _e1401 = select(0f, _e1399, (_e1399 > 0f));
let _e1403 = select(1f, _e1401, (_e1401 < 1f));
let _e1405 = (((_e1349 + ((_e1292 - _e1349) * _e1350)) * _e1369) + _e1374);
let _e1407 = select(0f, _e1405, (_e1405 > 0f));
let _e1409 = select(1f, _e1407, (_e1407 < 1f));
let _e1411 = (((_e1296 + (((_e1237 + (((_e1273 + ((bitcast<f32>(_e1282) - _e1273) * _e1284)) - _e1237) * _e1354)) - _e1296) * _e1358)) * _e1369) + _e1374);
let _e1413 = select(0f, _e1411, (_e1411 > 0f));
let _e1415 = select(1f, _e1413, (_e1413 < 1f));
let _e1416 = (_e1379 * 1024f);
let _e1417 = (1024f - 1f);
let _e1419 = select(0f, _e1416, (_e1416 > 0f));
let _e1421 = select(_e1417, _e1419, (_e1419 < _e1417));
let _e1428 = select(0i, select(select(i32(_e1421), i32(-2147483648), (_e1421 < -2147483600f)), 2147483647i, (_e1421 > 2147483500f)), (_e1421 == _e1421));
let _e1432 = (_e1428 - select(0i, 1i, (_e1421 < f32(_e1428))));
let _e1433 = (262147i + _e1432);
let _e1435 = (bitcast<i32>(_e92) - 1i);
let _e1437 = select(_e1435, _e1433, (_e1433 < _e1435));
let _e1443 = global_4.member[bitcast<u32>(select(0i, _e1437, (_e1437 > 0i)))];
let _e1453 = select(_e1435, 262146i, (262146i < _e1435));
let _e1459 = global_4.member[bitcast<u32>(select(0i, _e1453, (_e1453 > 0i)))];
let _e1460 = bitcast<f32>(_e1459);
let _e1461 = (f32((bitcast<i32>((_e1443 & 4095u)) - 2048i)) * _e1460);
let _e1463 = select(_e1435, 262144i, (262144i < _e1435));
let _e1469 = global_4.member[bitcast<u32>(select(0i, _e1463, (_e1463 > 0i)))];
let _e1470 = bitcast<f32>(_e1469);
let _e1472 = select(_e1435, 262145i, (262145i < _e1435));
let _e1478 = global_4.member[bitcast<u32>(select(0i, _e1472, (_e1472 > 0i)))];
let _e1479 = bitcast<f32>(_e1478);
let _e1485 = ((_e1470 + (f32(bitcast<i32>((_e1443 >> bitcast<u32>(12u)))) * _e1479)) + (_e1461 * (_e1416 - f32(_e1432))));
let _e1486 = (_e1461 * 1024f);
if _e716 {
let _e1493 = ((0.5f * (_e1391 - _e1385)) * _e1486);
let _e1494 = ((0.5f * (_e1403 - _e1397)) * _e1486);
let _e1495 = ((0.5f * (_e1415 - _e1409)) * _e1486);
phi_3135_ = type_29(_e1485, vec3<f32>(_e1493, _e1494, _e1495), vec3<f32>((_e1493 * _e1485), (_e1494 * _e1485), (_e1495 * _e1485)));
} else {
let _e1502 = (_e1385 * 1024f);
let _e1504 = select(0f, _e1502, (_e1502 > 0f));
let _e1506 = select(_e1417, _e1504, (_e1504 < _e1417));
let _e1513 = select(0i, select(select(i32(_e1506), i32(-2147483648), (_e1506 < -2147483600f)), 2147483647i, (_e1506 > 2147483500f)), (_e1506 == _e1506));
let _e1517 = (_e1513 - select(0i, 1i, (_e1506 < f32(_e1513))));
let _e1518 = (262147i + _e1517);
let _e1520 = select(_e1435, _e1518, (_e1518 < _e1435));
let _e1526 = global_4.member[bitcast<u32>(select(0i, _e1520, (_e1520 > 0i)))];
let _e1541 = ((_e1470 + (f32(bitcast<i32>((_e1526 >> bitcast<u32>(12u)))) * _e1479)) + ((f32((bitcast<i32>((_e1526 & 4095u)) - 2048i)) * _e1460) * (_e1502 - f32(_e1517))));
let _e1542 = (_e1391 * 1024f);
let _e1544 = select(0f, _e1542, (_e1542 > 0f));
let _e1546 = select(_e1417, _e1544, (_e1544 < _e1417));
let _e1553 = select(0i, select(select(i32(_e1546), i32(-2147483648), (_e1546 < -2147483600f)), 2147483647i, (_e1546 > 2147483500f)), (_e1546 == _e1546));
let _e1557 = (_e1553 - select(0i, 1i, (_e1546 < f32(_e1553))));
let _e1558 = (262147i + _e1557);
let _e1560 = select(_e1435, _e1558, (_e1558 < _e1435));
let _e1566 = global_4.member[bitcast<u32>(select(0i, _e1560, (_e1560 > 0i)))];
let _e1581 = ((_e1470 + (f32(bitcast<i32>((_e1566 >> bitcast<u32>(12u)))) * _e1479)) + ((f32((bitcast<i32>((_e1566 & 4095u)) - 2048i)) * _e1460) * (_e1542 - f32(_e1557))));
let _e1582 = (_e1397 * 1024f);
let _e1584 = select(0f, _e1582, (_e1582 > 0f));
let _e1586 = select(_e1417, _e1584, (_e1584 < _e1417));
let _e1593 = select(0i, select(select(i32(_e1586), i32(-2147483648), (_e1586 < -2147483600f)), 2147483647i, (_e1586 > 2147483500f)), (_e1586 == _e1586));
let _e1597 = (_e1593 - select(0i, 1i, (_e1586 < f32(_e1593))));
let _e1598 = (262147i + _e1597);
let _e1600 = select(_e1435, _e1598, (_e1598 < _e1435));
let _e1606 = global_4.member[bitcast<u32>(select(0i, _e1600, (_e1600 > 0i)))];
let _e1621 = ((_e1470 + (f32(bitcast<i32>((_e1606 >> bitcast<u32>(12u)))) * _e1479)) + ((f32((bitcast<i32>((_e1606 & 4095u)) - 2048i)) * _e1460) * (_e1582 - f32(_e1597))));
let _e1622 = (_e1403 * 1024f);
let _e1624 = select(0f, _e1622, (_e1622 > 0f));
let _e1626 = select(_e1417, _e1624, (_e1624 < _e1417));
let _e1633 = select(0i, select(select(i32(_e1626), i32(-2147483648), (_e1626 < -2147483600f)), 2147483647i, (_e1626 > 2147483500f)), (_e1626 == _e1626));
let _e1637 = (_e1633 - select(0i, 1i, (_e1626 < f32(_e1633))));
let _e1638 = (262147i + _e1637);
let _e1640 = select(_e1435, _e1638, (_e1638 < _e1435));
let _e1646 = global_4.member[bitcast<u32>(select(0i, _e1640, (_e1640 > 0i)))];
let _e1661 = ((_e1470 + (f32(bitcast<i32>((_e1646 >> bitcast<u32>(12u)))) * _e1479)) + ((f32((bitcast<i32>((_e1646 & 4095u)) - 2048i)) * _e1460) * (_e1622 - f32(_e1637))));
let _e1662 = (_e1409 * 1024f);
let _e1664 = select(0f, _e1662, (_e1662 > 0f));
let _e1666 = select(_e1417, _e1664, (_e1664 < _e1417));
let _e1673 = select(0i, select(select(i32(_e1666), i32(-2147483648), (_e1666 < -2147483600f)), 2147483647i, (_e1666 > 2147483500f)), (_e1666 == _e1666));
let _e1677 = (_e1673 - select(0i, 1i, (_e1666 < f32(_e1673))));
let _e1678 = (262147i + _e1677);
let _e1680 = select(_e1435, _e1678, (_e1678 < _e1435));
let _e1686 = global_4.member[bitcast<u32>(select(0i, _e1680, (_e1680 > 0i)))];
let _e1701 = ((_e1470 + (f32(bitcast<i32>((_e1686 >> bitcast<u32>(12u)))) * _e1479)) + ((f32((bitcast<i32>((_e1686 & 4095u)) - 2048i)) * _e1460) * (_e1662 - f32(_e1677))));
let _e1702 = (_e1415 * 1024f);
let _e1704 = select(0f, _e1702, (_e1702 > 0f));
let _e1706 = select(_e1417, _e1704, (_e1704 < _e1417));
let _e1713 = select(0i, select(select(i32(_e1706), i32(-2147483648), (_e1706 < -2147483600f)), 2147483647i, (_e1706 > 2147483500f)), (_e1706 == _e1706));
let _e1717 = (_e1713 - select(0i, 1i, (_e1706 < f32(_e1713))));
let _e1718 = (262147i + _e1717);
let _e1720 = select(_e1435, _e1718, (_e1718 < _e1435));
let _e1726 = global_4.member[bitcast<u32>(select(0i, _e1720, (_e1720 > 0i)))];
let _e1741 = ((_e1470 + (f32(bitcast<i32>((_e1726 >> bitcast<u32>(12u)))) * _e1479)) + ((f32((bitcast<i32>((_e1726 & 4095u)) - 2048i)) * _e1460) * (_e1702 - f32(_e1717))));
let _e1742 = (_e1581 - _e1541);
let _e1744 = (_e1661 - _e1621);
let _e1746 = (_e1741 - _e1701);
phi_3135_ = type_29(_e1485, vec3<f32>((0.5f * _e1742), (0.5f * _e1744), (0.5f * _e1746)), vec3<f32>((0.25f * (_e1742 * (_e1581 + _e1541))), (0.25f * (_e1744 * (_e1661 + _e1621))), (0.25f * (_e1746 * (_e1741 + _e1701)))));
}
let _e1761 = phi_3135_;
let _e1776 = select(0f, 1f, ((((((_e702 >= -0.5f) && (_e702 <= _e725)) && (_e708 >= -0.5f)) && (_e708 <= _e735)) && (_e714 >= -0.5f)) && (_e714 <= _e745)));
let _e1778 = (0.5f * (_e1391 - _e1385));
let _e1780 = (0.5f * (_e1403 - _e1397));
let _e1782 = (0.5f * (_e1415 - _e1409));
let _e1788 = global_1.member.member_6.member.member.member;
let _e1794 = global_1.member.member_6.member.member.member_1;
let _e1800 = global_1.member.member_6.member.member.member_2;
let _e1806 = global_1.member.member_6.member_1.member.member;
let _e1812 = global_1.member.member_6.member_1.member.member_1;
let _e1818 = global_1.member.member_6.member_1.member.member_2;
let _e1824 = global_1.member.member_6.member_2.member.member;
let _e1830 = global_1.member.member_6.member_2.member.member_1;
let _e1836 = global_1.member.member_6.member_2.member.member_2;
phi_3744_ = type_30(_e1379, vec3<f32>(((((_e1788 * _e1778) + (_e1806 * _e1780)) + (_e1824 * _e1782)) * _e1776), ((((_e1794 * _e1778) + (_e1812 * _e1780)) + (_e1830 * _e1782)) * _e1776), ((((_e1800 * _e1778) + (_e1818 * _e1780)) + (_e1836 * _e1782)) * _e1776)), _e1761.member, vec3<f32>(((((_e1788 * _e1761.member_2.x) + (_e1806 * _e1761.member_2.y)) + (_e1824 * _e1761.member_2.z)) * _e1776), ((((_e1794 * _e1761.member_2.x) + (_e1812 * _e1761.member_2.y)) + (_e1830 * _e1761.member_2.z)) * _e1776), ((((_e1800 * _e1761.member_2.x) + (_e1818 * _e1761.member_2.y)) + (_e1836 * _e1761.member_2.z)) * _e1776)), vec3<f32>(((((_e1788 * _e1761.member_1.x) + (_e1806 * _e1761.member_1.y)) + (_e1824 * _e1761.member_1.z)) * _e1776), ((((_e1794 * _e1761.member_1.x) + (_e1812 * _e1761.member_1.y)) + (_e1830 * _e1761.member_1.z)) * _e1776), ((((_e1800 * _e1761.member_1.x) + (_e1818 * _e1761.member_1.y)) + (_e1836 * _e1761.member_1.z)) * _e1776)));
} else {
let _e1905 = global_1.member.member_6.member_3.member;
let _e1906 = (_e1905 - 0.5f);
let _e1908 = select(-0.5f, _e702, (_e702 > -0.5f));
let _e1910 = select(_e1906, _e1908, (_e1908 < _e1906));
let _e1915 = global_1.member.member_6.member_3.member_1;
let _e1916 = (_e1915 - 0.5f);
let _e1918 = select(-0.5f, _e708, (_e708 > -0.5f));
let _e1920 = select(_e1916, _e1918, (_e1918 < _e1916));
let _e1925 = global_1.member.member_6.member_3.member_2;
let _e1926 = (_e1925 - 0.5f);
let _e1928 = select(-0.5f, _e714, (_e714 > -0.5f));
let _e1930 = select(_e1926, _e1928, (_e1928 < _e1926));
let _e1932 = select(-1f, _e1910, (_e1910 > -1f));
let _e1934 = select(_e1905, _e1932, (_e1932 < _e1905));
let _e1941 = select(0i, select(select(i32(_e1934), i32(-2147483648), (_e1934 < -2147483600f)), 2147483647i, (_e1934 > 2147483500f)), (_e1934 == _e1934));
let _e1945 = (_e1941 - select(0i, 1i, (_e1934 < f32(_e1941))));
let _e1947 = select(-1f, _e1920, (_e1920 > -1f));
let _e1949 = select(_e1915, _e1947, (_e1947 < _e1915));
let _e1956 = select(0i, select(select(i32(_e1949), i32(-2147483648), (_e1949 < -2147483600f)), 2147483647i, (_e1949 > 2147483500f)), (_e1949 == _e1949));
let _e1960 = (_e1956 - select(0i, 1i, (_e1949 < f32(_e1956))));
let _e1962 = select(-1f, _e1930, (_e1930 > -1f));
let _e1964 = select(_e1925, _e1962, (_e1962 < _e1925));
let _e1971 = select(0i, select(select(i32(_e1964), i32(-2147483648), (_e1964 < -2147483600f)), 2147483647i, (_e1964 > 2147483500f)), (_e1964 == _e1964));
let _e1975 = (_e1971 - select(0i, 1i, (_e1964 < f32(_e1971))));
let _e1979 = global_1.member.member_6.member_7;
let _e1983 = global_1.member.member_6.member_8;
let _e1984 = (_e1945 + 1i);
let _e1985 = (_e1960 + 1i);
let _e1986 = (_e1975 + 1i);
let _e1991 = global_1.member.member_6.member_11.member;
let _e1997 = global_1.member.member_6.member_11.member_1;
let _e2008 = ((_e1984 >> bitcast<u32>(4i)) + (bitcast<i32>(_e1991) * ((_e1985 >> bitcast<u32>(4i)) + (bitcast<i32>(_e1997) * (_e1986 >> bitcast<u32>(4i))))));
let _e2010 = (bitcast<i32>(_e88) - 1i);
let _e2012 = select(_e2010, _e2008, (_e2008 < _e2010));
let _e2018 = global_2.member[bitcast<u32>(select(0i, _e2012, (_e2012 > 0i)))];
let _e2020 = (_e1984 & 15i);
let _e2023 = ((_e1985 & 15i) * _e1979);
let _e2025 = (bitcast<i32>(_e2018) + ((_e1986 & 15i) * _e1983));
let _e2029 = (_e2023 + _e1979);
let _e2031 = (_e2023 + (2i * _e1979));
let _e2032 = (_e2025 + _e1983);
let _e2034 = (_e2025 + (2i * _e1983));
local_2 = type_28(array<i32, 4>(_e2020, (_e2020 + 1i), (_e2020 + 2i), (_e2020 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_3 = vec3<f32>((_e1910 - f32(_e1945)), (_e1920 - f32(_e1960)), (_e1930 - f32(_e1975)));
let _e2045 = (_e2032 + _e2029);
let _e2048 = local_2.member[1u];
let _e2049 = (_e2045 + _e2048);
let _e2051 = select(_e2010, _e2049, (_e2049 < _e2010));
let _e2056 = global_2.member[bitcast<u32>(select(0i, _e2051, (_e2051 > 0i)))];
let _e2057 = bitcast<f32>(_e2056);
let _e2060 = local_2.member[2u];
let _e2061 = (_e2045 + _e2060);
let _e2063 = select(_e2010, _e2061, (_e2061 < _e2010));
let _e2068 = global_2.member[bitcast<u32>(select(0i, _e2063, (_e2063 > 0i)))];
let _e2070 = local_3[0u];
let _e2073 = (_e2057 + ((bitcast<f32>(_e2068) - _e2057) * _e2070));
let _e2074 = (_e2032 + _e2031);
let _e2075 = local_2.member[1u];
let _e2076 = (_e2074 + _e2075);
let _e2078 = select(_e2010, _e2076, (_e2076 < _e2010));
let _e2083 = global_2.member[bitcast<u32>(select(0i, _e2078, (_e2078 > 0i)))];
let _e2084 = bitcast<f32>(_e2083);
let _e2085 = local_2.member[2u];
let _e2086 = (_e2074 + _e2085);
let _e2088 = select(_e2010, _e2086, (_e2086 < _e2010));
let _e2093 = global_2.member[bitcast<u32>(select(0i, _e2088, (_e2088 > 0i)))];
let _e2095 = local_3[0u];
let _e2100 = local_3[1u];
let _e2103 = (_e2073 + (((_e2084 + ((bitcast<f32>(_e2093) - _e2084) * _e2095)) - _e2073) * _e2100));
let _e2104 = (_e2034 + _e2029);
let _e2105 = local_2.member[1u];
let _e2106 = (_e2104 + _e2105);
let _e2108 = select(_e2010, _e2106, (_e2106 < _e2010));
let _e2113 = global_2.member[bitcast<u32>(select(0i, _e2108, (_e2108 > 0i)))];
let _e2114 = bitcast<f32>(_e2113);
let _e2115 = local_2.member[2u];
let _e2116 = (_e2104 + _e2115);
let _e2118 = select(_e2010, _e2116, (_e2116 < _e2010));
let _e2123 = global_2.member[bitcast<u32>(select(0i, _e2118, (_e2118 > 0i)))];
let _e2125 = local_3[0u];
let _e2128 = (_e2114 + ((bitcast<f32>(_e2123) - _e2114) * _e2125));
let _e2129 = (_e2034 + _e2031);
let _e2130 = local_2.member[1u];
let _e2131 = (_e2129 + _e2130);
let _e2133 = select(_e2010, _e2131, (_e2131 < _e2010));
let _e2138 = global_2.member[bitcast<u32>(select(0i, _e2133, (_e2133 > 0i)))];
let _e2139 = bitcast<f32>(_e2138);
let _e2140 = local_2.member[2u];
let _e2141 = (_e2129 + _e2140);
let _e2143 = select(_e2010, _e2141, (_e2141 < _e2010));
let _e2148 = global_2.member[bitcast<u32>(select(0i, _e2143, (_e2143 > 0i)))];
let _e2150 = local_3[0u];
let _e2154 = local_3[1u];
let _e2159 = local_3[2u];
let _e2166 = global_1.member.member_6.member_5;
let _e2171 = global_1.member.member_6.member_6;
let _e2172 = (((_e2103 + (((_e2128 + (((_e2139 + ((bitcast<f32>(_e2148) - _e2139) * _e2150)) - _e2128) * _e2154)) - _e2103) * _e2159)) * _e2166) + _e2171);
let _e2174 = select(0f, _e2172, (_e2172 > 0f));
phi_3744_ = type_30(select(1f, _e2174, (_e2174 < 1f)), vec3<f32>(0f, 0f, 0f), 1f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
}
let _e2179 = phi_3744_;
let _e2184 = global_1.member.member_6.member_3.member;
let _e2185 = (_e2184 - 0.5f);
let _e2187 = select(-0.5f, _e666, (_e666 > -0.5f));
let _e2189 = select(_e2185, _e2187, (_e2187 < _e2185));
let _e2194 = global_1.member.member_6.member_3.member_1;
let _e2195 = (_e2194 - 0.5f);
let _e2197 = select(-0.5f, _e681, (_e681 > -0.5f));
let _e2199 = select(_e2195, _e2197, (_e2197 < _e2195));
let _e2204 = global_1.member.member_6.member_3.member_2;
let _e2205 = (_e2204 - 0.5f);
let _e2207 = select(-0.5f, _e696, (_e696 > -0.5f));
let _e2209 = select(_e2205, _e2207, (_e2207 < _e2205));
let _e2211 = select(-1f, _e2189, (_e2189 > -1f));
let _e2213 = select(_e2184, _e2211, (_e2211 < _e2184));
let _e2220 = select(0i, select(select(i32(_e2213), i32(-2147483648), (_e2213 < -2147483600f)), 2147483647i, (_e2213 > 2147483500f)), (_e2213 == _e2213));
let _e2224 = (_e2220 - select(0i, 1i, (_e2213 < f32(_e2220))));
let _e2226 = select(-1f, _e2199, (_e2199 > -1f));
let _e2228 = select(_e2194, _e2226, (_e2226 < _e2194));
let _e2235 = select(0i, select(select(i32(_e2228), i32(-2147483648), (_e2228 < -2147483600f)), 2147483647i, (_e2228 > 2147483500f)), (_e2228 == _e2228));
let _e2239 = (_e2235 - select(0i, 1i, (_e2228 < f32(_e2235))));
let _e2241 = select(-1f, _e2209, (_e2209 > -1f));
let _e2243 = select(_e2204, _e2241, (_e2241 < _e2204));
let _e2250 = select(0i, select(select(i32(_e2243), i32(-2147483648), (_e2243 < -2147483600f)), 2147483647i, (_e2243 > 2147483500f)), (_e2243 == _e2243));
let _e2254 = (_e2250 - select(0i, 1i, (_e2243 < f32(_e2250))));
let _e2258 = global_1.member.member_6.member_7;
let _e2262 = global_1.member.member_6.member_8;
let _e2263 = (_e2224 + 1i);
let _e2264 = (_e2239 + 1i);
let _e2265 = (_e2254 + 1i);
let _e2270 = global_1.member.member_6.member_11.member;
let _e2276 = global_1.member.member_6.member_11.member_1;
let _e2287 = ((_e2263 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2270) * ((_e2264 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2276) * (_e2265 >> bitcast<u32>(4i))))));
let _e2289 = (bitcast<i32>(_e88) - 1i);
let _e2291 = select(_e2289, _e2287, (_e2287 < _e2289));
let _e2297 = global_2.member[bitcast<u32>(select(0i, _e2291, (_e2291 > 0i)))];
let _e2299 = (_e2263 & 15i);
let _e2302 = ((_e2264 & 15i) * _e2258);
let _e2304 = (bitcast<i32>(_e2297) + ((_e2265 & 15i) * _e2262));
let _e2308 = (_e2302 + _e2258);
let _e2310 = (_e2302 + (2i * _e2258));
let _e2311 = (_e2304 + _e2262);
let _e2313 = (_e2304 + (2i * _e2262));
local = type_28(array<i32, 4>(_e2299, (_e2299 + 1i), (_e2299 + 2i), (_e2299 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_1 = vec3<f32>((_e2189 - f32(_e2224)), (_e2199 - f32(_e2239)), (_e2209 - f32(_e2254)));
let _e2324 = (_e2311 + _e2308);
let _e2327 = local.member[1u];
let _e2328 = (_e2324 + _e2327);
let _e2330 = select(_e2289, _e2328, (_e2328 < _e2289));
let _e2335 = global_2.member[bitcast<u32>(select(0i, _e2330, (_e2330 > 0i)))];
let _e2336 = bitcast<f32>(_e2335);
let _e2339 = local.member[2u];
let _e2340 = (_e2324 + _e2339);
let _e2342 = select(_e2289, _e2340, (_e2340 < _e2289));
let _e2347 = global_2.member[bitcast<u32>(select(0i, _e2342, (_e2342 > 0i)))];
let _e2349 = local_1[0u];
let _e2352 = (_e2336 + ((bitcast<f32>(_e2347) - _e2336) * _e2349));
let _e2353 = (_e2311 + _e2310);
let _e2354 = local.member[1u];
let _e2355 = (_e2353 + _e2354);
let _e2357 = select(_e2289, _e2355, (_e2355 < _e2289));
let _e2362 = global_2.member[bitcast<u32>(select(0i, _e2357, (_e2357 > 0i)))];
let _e2363 = bitcast<f32>(_e2362);
let _e2364 = local.member[2u];
let _e2365 = (_e2353 + _e2364);
let _e2367 = select(_e2289, _e2365, (_e2365 < _e2289));
let _e2372 = global_2.member[bitcast<u32>(select(0i, _e2367, (_e2367 > 0i)))];
let _e2374 = local_1[0u];
let _e2379 = local_1[1u];
let _e2382 = (_e2352 + (((_e2363 + ((bitcast<f32>(_e2372) - _e2363) * _e2374)) - _e2352) * _e2379));
let _e2383 = (_e2313 + _e2308);
let _e2384 = local.member[1u];
let _e2385 = (_e2383 + _e2384);
let _e2387 = select(_e2289, _e2385, (_e2385 < _e2289));
let _e2392 = global_2.member[bitcast<u32>(select(0i, _e2387, (_e2387 > 0i)))];
let _e2393 = bitcast<f32>(_e2392);
let _e2394 = local.member[2u];
let _e2395 = (_e2383 + _e2394);
let _e2397 = select(_e2289, _e2395, (_e2395 < _e2289));
let _e2402 = global_2.member[bitcast<u32>(select(0i, _e2397, (_e2397 > 0i)))];
let _e2404 = local_1[0u];
let _e2407 = (_e2393 + ((bitcast<f32>(_e2402) - _e2393) * _e2404));
let _e2408 = (_e2313 + _e2310);
let _e2409 = local.member[1u];
let _e2410 = (_e2408 + _e2409);
let _e2412 = select(_e2289, _e2410, (_e2410 < _e2289));
let _e2417 = global_2.member[bitcast<u32>(select(0i, _e2412, (_e2412 > 0i)))];
let _e2418 = bitcast<f32>(_e2417);
let _e2419 = local.member[2u];
let _e2420 = (_e2408 + _e2419);
let _e2422 = select(_e2289, _e2420, (_e2420 < _e2289));
let _e2427 = global_2.member[bitcast<u32>(select(0i, _e2422, (_e2422 > 0i)))];
let _e2429 = local_1[0u];
let _e2433 = local_1[1u];
let _e2438 = local_1[2u];
let _e2445 = global_1.member.member_6.member_5;
let _e2450 = global_1.member.member_6.member_6;
let _e2451 = (((_e2382 + (((_e2407 + (((_e2418 + ((bitcast<f32>(_e2427) - _e2418) * _e2429)) - _e2407) * _e2433)) - _e2382) * _e2438)) * _e2445) + _e2450);
let _e2453 = select(0f, _e2451, (_e2451 > 0f));
let _e2455 = select(1f, _e2453, (_e2453 < 1f));
let _e2458 = global_1.member.member_1;
if ((_e2458 & 16u) == 0u) {
phi_4540_ = type_5(1f, 1f, 1f);
} else {
let _e2464 = global_1.member.member_14.member;
let _e2475 = ((((_e2464.member.member * _e623) + (_e2464.member.member_1 * _e636)) + (_e2464.member.member_2 * _e601)) + _e2464.member_1);
let _e2481 = ((((_e2464.member.member * _e646) + (_e2464.member.member_1 * _e651)) + (_e2464.member.member_2 * _e640)) + _e2464.member_1);
let _e2483 = select(_e2481, _e2475, (_e2475 < _e2481));
let _e2485 = select(_e2481, _e2475, (_e2475 > _e2481));
let _e2487 = (_e2485 - _e2483);
let _e2490 = (-(_e2483) / select(1e-30f, _e2487, (_e2487 > 1e-30f)));
let _e2492 = select(0f, _e2490, (_e2490 > 0f));
let _e2498 = select(select(select(1f, _e2492, (_e2492 < 1f)), 1f, (_e2485 <= 0f)), 0f, (_e2483 > 0f));
let _e2503 = global_1.member.member_14.member_1;
let _e2504 = (_e2503 != 0u);
let _e2514 = global_1.member.member_15.member;
let _e2525 = ((((_e2514.member.member * _e623) + (_e2514.member.member_1 * _e636)) + (_e2514.member.member_2 * _e601)) + _e2514.member_1);
let _e2531 = ((((_e2514.member.member * _e646) + (_e2514.member.member_1 * _e651)) + (_e2514.member.member_2 * _e640)) + _e2514.member_1);
let _e2533 = select(_e2531, _e2525, (_e2525 < _e2531));
let _e2535 = select(_e2531, _e2525, (_e2525 > _e2531));
let _e2537 = (_e2535 - _e2533);
let _e2540 = (-(_e2533) / select(1e-30f, _e2537, (_e2537 > 1e-30f)));
let _e2542 = select(0f, _e2540, (_e2540 > 0f));
let _e2548 = select(select(select(1f, _e2542, (_e2542 < 1f)), 1f, (_e2535 <= 0f)), 0f, (_e2533 > 0f));
let _e2553 = global_1.member.member_15.member_1;
let _e2554 = (_e2553 != 0u);
let _e2564 = global_1.member.member_16.member;
let _e2575 = ((((_e2564.member.member * _e623) + (_e2564.member.member_1 * _e636)) + (_e2564.member.member_2 * _e601)) + _e2564.member_1);
let _e2581 = ((((_e2564.member.member * _e646) + (_e2564.member.member_1 * _e651)) + (_e2564.member.member_2 * _e640)) + _e2564.member_1);
let _e2583 = select(_e2581, _e2575, (_e2575 < _e2581));
let _e2585 = select(_e2581, _e2575, (_e2575 > _e2581));
let _e2587 = (_e2585 - _e2583);
let _e2590 = (-(_e2583) / select(1e-30f, _e2587, (_e2587 > 1e-30f)));
let _e2592 = select(0f, _e2590, (_e2590 > 0f));
let _e2598 = select(select(select(1f, _e2592, (_e2592 < 1f)), 1f, (_e2585 <= 0f)), 0f, (_e2583 > 0f));
let _e2603 = global_1.member.member_16.member_1;
let _e2604 = (_e2603 != 0u);
let _e2614 = global_1.member.member_17.member;
let _e2625 = ((((_e2614.member.member * _e623) + (_e2614.member.member_1 * _e636)) + (_e2614.member.member_2 * _e601)) + _e2614.member_1);
let _e2631 = ((((_e2614.member.member * _e646) + (_e2614.member.member_1 * _e651)) + (_e2614.member.member_2 * _e640)) + _e2614.member_1);
let _e2633 = select(_e2631, _e2625, (_e2625 < _e2631));
let _e2635 = select(_e2631, _e2625, (_e2625 > _e2631));
let _e2637 = (_e2635 - _e2633);
let _e2640 = (-(_e2633) / select(1e-30f, _e2637, (_e2637 > 1e-30f)));
let _e2642 = select(0f, _e2640, (_e2640 > 0f));
let _e2648 = select(select(select(1f, _e2642, (_e2642 < 1f)), 1f, (_e2635 <= 0f)), 0f, (_e2633 > 0f));
let _e2653 = global_1.member.member_17.member_1;
let _e2654 = (_e2653 != 0u);
phi_4540_ = type_5(((((1f * _e2498) * _e2548) * _e2598) * _e2648), ((((1f * select(1f, _e2498, _e2504)) * select(1f, _e2548, _e2554)) * select(1f, _e2598, _e2604)) * select(1f, _e2648, _e2654)), ((((1f * select(1f, 0f, (_e2504 && (_e2481 > 0f)))) * select(1f, 0f, (_e2554 && (_e2531 > 0f)))) * select(1f, 0f, (_e2604 && (_e2581 > 0f)))) * select(1f, 0f, (_e2654 && (_e2631 > 0f)))));
}
let _e2663 = phi_4540_;
let _e2664 = (_e702 - _e666);
let _e2668 = (bitcast<f32>((bitcast<u32>(_e2664) & 2147483647u)) < 1e-12f);
let _e2670 = (1f / select(_e2664, 1f, _e2668));
let _e2672 = ((-0.5f - _e666) * _e2670);
let _e2674 = ((_e2185 - _e666) * _e2670);
let _e2680 = select(_e2674, _e2672, (_e2672 < _e2674));
let _e2682 = select(0f, _e2680, (_e2680 > 0f));
let _e2685 = select(select(1f, _e2682, (_e2682 < 1f)), select(2f, 0f, ((_e666 >= -0.5f) && (_e666 <= _e2185))), _e2668);
let _e2687 = select(_e2674, _e2672, (_e2672 > _e2674));
let _e2689 = select(0f, _e2687, (_e2687 > 0f));
let _e2692 = select(select(1f, _e2689, (_e2689 < 1f)), 1f, _e2668);
let _e2693 = (_e708 - _e681);
let _e2697 = (bitcast<f32>((bitcast<u32>(_e2693) & 2147483647u)) < 1e-12f);
let _e2699 = (1f / select(_e2693, 1f, _e2697));
let _e2701 = ((-0.5f - _e681) * _e2699);
let _e2703 = ((_e2195 - _e681) * _e2699);
let _e2709 = select(_e2703, _e2701, (_e2701 < _e2703));
let _e2711 = select(0f, _e2709, (_e2709 > 0f));
let _e2714 = select(select(1f, _e2711, (_e2711 < 1f)), select(2f, 0f, ((_e681 >= -0.5f) && (_e681 <= _e2195))), _e2697);
let _e2716 = select(_e2703, _e2701, (_e2701 > _e2703));
let _e2718 = select(0f, _e2716, (_e2716 > 0f));
let _e2721 = select(select(1f, _e2718, (_e2718 < 1f)), 1f, _e2697);
let _e2722 = (_e714 - _e696);
let _e2726 = (bitcast<f32>((bitcast<u32>(_e2722) & 2147483647u)) < 1e-12f);
let _e2728 = (1f / select(_e2722, 1f, _e2726));
let _e2730 = ((-0.5f - _e696) * _e2728);
let _e2732 = ((_e2205 - _e696) * _e2728);
let _e2738 = select(_e2732, _e2730, (_e2730 < _e2732));
let _e2740 = select(0f, _e2738, (_e2738 > 0f));
let _e2743 = select(select(1f, _e2740, (_e2740 < 1f)), select(2f, 0f, ((_e696 >= -0.5f) && (_e696 <= _e2205))), _e2726);
let _e2745 = select(_e2732, _e2730, (_e2730 > _e2732));
let _e2747 = select(0f, _e2745, (_e2745 > 0f));
let _e2750 = select(select(1f, _e2747, (_e2747 < 1f)), 1f, _e2726);
let _e2752 = select(_e2721, _e2692, (_e2692 < _e2721));
let _e2756 = select(_e2714, _e2685, (_e2685 > _e2714));
let _e2759 = (select(_e2750, _e2752, (_e2752 < _e2750)) - select(_e2743, _e2756, (_e2756 > _e2743)));
let _e2762 = (_e646 - _e623);
let _e2763 = (_e651 - _e636);
let _e2764 = (_e640 - _e601);
let _e2769 = (((_e2762 * _e2762) + (_e2763 * _e2763)) + (_e2764 * _e2764));
let _e2777 = global_1.member.member_5.member_3;
let _e2778 = ((sqrt(select(0f, _e2769, (_e2769 > 0f))) * select(0f, _e2759, (_e2759 > 0f))) * _e2777);
if (_e102.member_2 >= 3u) {
let _e2781 = (_e2455 * 255f);
let _e2782 = (_e2179.member * 255f);
let _e2783 = (255f - 1f);
let _e2785 = select(0f, _e2781, (_e2781 > 0f));
let _e2787 = select(_e2783, _e2785, (_e2785 < _e2783));
let _e2794 = select(0i, select(select(i32(_e2787), i32(-2147483648), (_e2787 < -2147483600f)), 2147483647i, (_e2787 > 2147483500f)), (_e2787 == _e2787));
let _e2798 = (_e2794 - select(0i, 1i, (_e2787 < f32(_e2794))));
let _e2800 = select(0f, _e2782, (_e2782 > 0f));
let _e2802 = select(_e2783, _e2800, (_e2800 < _e2783));
let _e2809 = select(0i, select(select(i32(_e2802), i32(-2147483648), (_e2802 < -2147483600f)), 2147483647i, (_e2802 > 2147483500f)), (_e2802 == _e2802));
let _e2813 = (_e2809 - select(0i, 1i, (_e2802 < f32(_e2809))));
let _e2816 = (((_e2798 * 256i) + _e2813) * 4i);
let _e2820 = (_e2782 - f32(_e2813));
let _e2822 = (bitcast<i32>(_e92) - 1i);
let _e2824 = select(_e2822, _e2816, (_e2816 < _e2822));
let _e2830 = global_4.member[bitcast<u32>(select(0i, _e2824, (_e2824 > 0i)))];
let _e2831 = (_e2816 + 4i);
let _e2833 = select(_e2822, _e2831, (_e2831 < _e2822));
let _e2839 = global_4.member[bitcast<u32>(select(0i, _e2833, (_e2833 > 0i)))];
let _e2840 = (_e2816 + 1024i);
let _e2842 = select(_e2822, _e2840, (_e2840 < _e2822));
let _e2848 = global_4.member[bitcast<u32>(select(0i, _e2842, (_e2842 > 0i)))];
let _e2849 = (_e2816 + 1028i);
let _e2851 = select(_e2822, _e2849, (_e2849 < _e2822));
let _e2857 = global_4.member[bitcast<u32>(select(0i, _e2851, (_e2851 > 0i)))];
let _e2862 = (bitcast<f32>(((_e2830 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e2870 = (_e2862 + (((bitcast<f32>(((_e2839 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e2862) * _e2820));
let _e2875 = (bitcast<f32>(((_e2848 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e2886 = (_e2870 + (((_e2875 + (((bitcast<f32>(((_e2857 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e2875) * _e2820)) - _e2870) * (_e2781 - f32(_e2798))));
let _e2890 = -((_e2886 * (_e2778 * _e2663.member)));
let _e2892 = select(-87f, _e2890, (_e2890 > -87f));
let _e2894 = select(88f, _e2892, (_e2892 < 88f));
let _e2896 = ((_e2894 * 1.442695f) + 0.5f);
let _e2898 = select(-127f, _e2896, (_e2896 > -127f));
let _e2900 = select(128f, _e2898, (_e2898 < 128f));
let _e2907 = select(0i, select(select(i32(_e2900), i32(-2147483648), (_e2900 < -2147483600f)), 2147483647i, (_e2900 > 2147483500f)), (_e2900 == _e2900));
let _e2911 = (_e2907 - select(0i, 1i, (_e2900 < f32(_e2907))));
let _e2912 = f32(_e2911);
let _e2916 = ((_e2894 - (_e2912 * 0.6933594f)) - (_e2912 * -2.1219444e-4f));
let _e2936 = ((1f + (_e2916 * (1f + (_e2916 * (0.5f + (_e2916 * (0.16666667f + (_e2916 * (0.041666668f + (_e2916 * (0.008333334f + (_e2916 * (0.001388889f + (_e2916 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2911 + 127i)) << bitcast<u32>(23i))));
let _e2937 = (1f - _e2936);
phi_5650_ = type_31(_e2936, _e2937, vec3<f32>(1f, 1f, 1f), vec3((0f * (_e2937 / select(1e-12f, _e2886, (_e2886 > 1e-12f))))));
} else {
let _e2945 = (_e2455 * 255f);
let _e2946 = (_e2179.member * 255f);
let _e2947 = (255f - 1f);
let _e2949 = select(0f, _e2945, (_e2945 > 0f));
let _e2951 = select(_e2947, _e2949, (_e2949 < _e2947));
let _e2958 = select(0i, select(select(i32(_e2951), i32(-2147483648), (_e2951 < -2147483600f)), 2147483647i, (_e2951 > 2147483500f)), (_e2951 == _e2951));
let _e2962 = (_e2958 - select(0i, 1i, (_e2951 < f32(_e2958))));
let _e2964 = select(0f, _e2946, (_e2946 > 0f));
let _e2966 = select(_e2947, _e2964, (_e2964 < _e2947));
let _e2973 = select(0i, select(select(i32(_e2966), i32(-2147483648), (_e2966 < -2147483600f)), 2147483647i, (_e2966 > 2147483500f)), (_e2966 == _e2966));
let _e2977 = (_e2973 - select(0i, 1i, (_e2966 < f32(_e2973))));
let _e2980 = (((_e2962 * 256i) + _e2977) * 4i);
let _e2982 = (_e2945 - f32(_e2962));
let _e2984 = (_e2946 - f32(_e2977));
let _e2986 = (bitcast<i32>(_e92) - 1i);
let _e2988 = select(_e2986, _e2980, (_e2980 < _e2986));
let _e2994 = global_4.member[bitcast<u32>(select(0i, _e2988, (_e2988 > 0i)))];
let _e2995 = (_e2980 + 4i);
let _e2997 = select(_e2986, _e2995, (_e2995 < _e2986));
let _e3003 = global_4.member[bitcast<u32>(select(0i, _e2997, (_e2997 > 0i)))];
let _e3004 = (_e2980 + 1024i);
let _e3006 = select(_e2986, _e3004, (_e3004 < _e2986));
let _e3012 = global_4.member[bitcast<u32>(select(0i, _e3006, (_e3006 > 0i)))];
let _e3013 = (_e2980 + 1028i);
let _e3015 = select(_e2986, _e3013, (_e3013 < _e2986));
let _e3021 = global_4.member[bitcast<u32>(select(0i, _e3015, (_e3015 > 0i)))];
let _e3026 = (bitcast<f32>(((_e2994 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3034 = (_e3026 + (((bitcast<f32>(((_e3003 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3026) * _e2984));
let _e3039 = (bitcast<f32>(((_e3012 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3050 = (_e3034 + (((_e3039 + (((bitcast<f32>(((_e3021 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3039) * _e2984)) - _e3034) * _e2982));
let _e3063 = (bitcast<f32>((((_e2994 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3071 = (_e3063 + (((bitcast<f32>((((_e3003 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3063) * _e2984));
let _e3076 = (bitcast<f32>((((_e3012 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3088 = (_e2980 + 1i);
let _e3090 = select(_e2986, _e3088, (_e3088 < _e2986));
let _e3096 = global_4.member[bitcast<u32>(select(0i, _e3090, (_e3090 > 0i)))];
let _e3097 = (_e2980 + 5i);
let _e3099 = select(_e2986, _e3097, (_e3097 < _e2986));
let _e3105 = global_4.member[bitcast<u32>(select(0i, _e3099, (_e3099 > 0i)))];
let _e3106 = (_e2980 + 1025i);
let _e3108 = select(_e2986, _e3106, (_e3106 < _e2986));
let _e3114 = global_4.member[bitcast<u32>(select(0i, _e3108, (_e3108 > 0i)))];
let _e3115 = (_e2980 + 1029i);
let _e3117 = select(_e2986, _e3115, (_e3115 < _e2986));
let _e3123 = global_4.member[bitcast<u32>(select(0i, _e3117, (_e3117 > 0i)))];
let _e3128 = (bitcast<f32>(((_e3096 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3136 = (_e3128 + (((bitcast<f32>(((_e3105 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3128) * _e2984));
let _e3141 = (bitcast<f32>(((_e3114 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3165 = (bitcast<f32>((((_e3096 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3173 = (_e3165 + (((bitcast<f32>((((_e3105 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3165) * _e2984));
let _e3178 = (bitcast<f32>((((_e3114 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3193 = (_e2778 * _e2663.member_1);
let _e3195 = -(((_e3071 + (((_e3076 + (((bitcast<f32>((((_e3021 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3076) * _e2984)) - _e3071) * _e2982)) * _e3193));
let _e3197 = select(-87f, _e3195, (_e3195 > -87f));
let _e3199 = select(88f, _e3197, (_e3197 < 88f));
let _e3201 = ((_e3199 * 1.442695f) + 0.5f);
let _e3203 = select(-127f, _e3201, (_e3201 > -127f));
let _e3205 = select(128f, _e3203, (_e3203 < 128f));
let _e3212 = select(0i, select(select(i32(_e3205), i32(-2147483648), (_e3205 < -2147483600f)), 2147483647i, (_e3205 > 2147483500f)), (_e3205 == _e3205));
let _e3216 = (_e3212 - select(0i, 1i, (_e3205 < f32(_e3212))));
let _e3217 = f32(_e3216);
let _e3221 = ((_e3199 - (_e3217 * 0.6933594f)) - (_e3217 * -2.1219444e-4f));
let _e3243 = -(((_e3136 + (((_e3141 + (((bitcast<f32>(((_e3123 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3141) * _e2984)) - _e3136) * _e2982)) * _e3193));
let _e3245 = select(-87f, _e3243, (_e3243 > -87f));
let _e3247 = select(88f, _e3245, (_e3245 < 88f));
let _e3249 = ((_e3247 * 1.442695f) + 0.5f);
let _e3251 = select(-127f, _e3249, (_e3249 > -127f));
let _e3253 = select(128f, _e3251, (_e3251 < 128f));
let _e3260 = select(0i, select(select(i32(_e3253), i32(-2147483648), (_e3253 < -2147483600f)), 2147483647i, (_e3253 > 2147483500f)), (_e3253 == _e3253));
let _e3264 = (_e3260 - select(0i, 1i, (_e3253 < f32(_e3260))));
let _e3265 = f32(_e3264);
let _e3269 = ((_e3247 - (_e3265 * 0.6933594f)) - (_e3265 * -2.1219444e-4f));
let _e3291 = -(((_e3173 + (((_e3178 + (((bitcast<f32>((((_e3123 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3178) * _e2984)) - _e3173) * _e2982)) * _e3193));
let _e3293 = select(-87f, _e3291, (_e3291 > -87f));
let _e3295 = select(88f, _e3293, (_e3293 < 88f));
let _e3297 = ((_e3295 * 1.442695f) + 0.5f);
let _e3299 = select(-127f, _e3297, (_e3297 > -127f));
let _e3301 = select(128f, _e3299, (_e3299 < 128f));
let _e3308 = select(0i, select(select(i32(_e3301), i32(-2147483648), (_e3301 < -2147483600f)), 2147483647i, (_e3301 > 2147483500f)), (_e3301 == _e3301));
let _e3312 = (_e3308 - select(0i, 1i, (_e3301 < f32(_e3308))));
let _e3313 = f32(_e3312);
let _e3317 = ((_e3295 - (_e3313 * 0.6933594f)) - (_e3313 * -2.1219444e-4f));
let _e3340 = -((_e3050 * (_e2778 * _e2663.member)));
let _e3342 = select(-87f, _e3340, (_e3340 > -87f));
let _e3344 = select(88f, _e3342, (_e3342 < 88f));
let _e3346 = ((_e3344 * 1.442695f) + 0.5f);
let _e3348 = select(-127f, _e3346, (_e3346 > -127f));
let _e3350 = select(128f, _e3348, (_e3348 < 128f));
let _e3357 = select(0i, select(select(i32(_e3350), i32(-2147483648), (_e3350 < -2147483600f)), 2147483647i, (_e3350 > 2147483500f)), (_e3350 == _e3350));
let _e3361 = (_e3357 - select(0i, 1i, (_e3350 < f32(_e3357))));
let _e3362 = f32(_e3361);
let _e3366 = ((_e3344 - (_e3362 * 0.6933594f)) - (_e3362 * -2.1219444e-4f));
let _e3386 = ((1f + (_e3366 * (1f + (_e3366 * (0.5f + (_e3366 * (0.16666667f + (_e3366 * (0.041666668f + (_e3366 * (0.008333334f + (_e3366 * (0.001388889f + (_e3366 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3361 + 127i)) << bitcast<u32>(23i))));
let _e3387 = (1f - _e3386);
phi_5650_ = type_31(_e3386, _e3387, vec3<f32>(((1f + (_e3221 * (1f + (_e3221 * (0.5f + (_e3221 * (0.16666667f + (_e3221 * (0.041666668f + (_e3221 * (0.008333334f + (_e3221 * (0.001388889f + (_e3221 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3216 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e3269 * (1f + (_e3269 * (0.5f + (_e3269 * (0.16666667f + (_e3269 * (0.041666668f + (_e3269 * (0.008333334f + (_e3269 * (0.001388889f + (_e3269 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3264 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e3317 * (1f + (_e3317 * (0.5f + (_e3317 * (0.16666667f + (_e3317 * (0.041666668f + (_e3317 * (0.008333334f + (_e3317 * (0.001388889f + (_e3317 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3312 + 127i)) << bitcast<u32>(23i))))), vec3((0f * (_e3387 / select(1e-12f, _e3050, (_e3050 > 1e-12f))))));
}
let _e3395 = phi_5650_;
if _e719 {
let _e3399 = global_1.member.member_5.member_2;
let _e3407 = global_1.member.member_5.member_4;
let _e3410 = (_e2179.member_3.x * _e2663.member_2);
let _e3412 = (_e2179.member_3.y * _e2663.member_2);
let _e3414 = (_e2179.member_3.z * _e2663.member_2);
let _e3415 = (0.5f * (_e3399 / select(1e-6f, _e182, (_e182 > 1e-6f))));
let _e3419 = (_e160 + (_e3410 * _e3415));
let _e3420 = (_e171 + (_e3412 * _e3415));
let _e3421 = (_e182 + (_e3414 * _e3415));
let _e3423 = (2f * _e3399);
let _e3425 = ((_e3421 * _e3421) + (_e3423 * _e3414));
let _e3429 = (_e3421 + sqrt(select(0f, _e3425, (_e3425 > 0f))));
let _e3433 = (0.5f * (_e3423 / select(1e-6f, _e3429, (_e3429 > 1e-6f))));
let _e3437 = (_e3419 + (_e3410 * _e3433));
let _e3438 = (_e3420 + (_e3412 * _e3433));
let _e3439 = (_e3421 + (_e3414 * _e3433));
let _e3443 = (_e3407 * _e3407);
let _e3445 = (_e3439 * _e3439);
let _e3453 = (((_e3421 <= 0f) || (_e3425 <= 0f)) || ((_e3439 <= 0f) || (_e3445 <= (_e3443 * (((_e3437 * _e3437) + (_e3438 * _e3438)) + _e3445)))));
let _e3467 = (_e160 + ((_e2179.member_4.x * _e2663.member_2) * _e3399));
let _e3468 = (_e171 + ((_e2179.member_4.y * _e2663.member_2) * _e3399));
let _e3469 = (_e182 + ((_e2179.member_4.z * _e2663.member_2) * _e3399));
let _e3471 = (_e3469 * _e3469);
let _e3480 = ((_e2458 & 1u) != 0u);
let _e3484 = select(_e3453, ((_e3469 <= 0f) || (_e3471 <= (_e3443 * (((_e3467 * _e3467) + (_e3468 * _e3468)) + _e3471)))), _e3480);
phi_5802_ = vec3<f32>(select(select(select(_e3437, _e3419, _e3453), _e3467, _e3480), _e160, _e3484), select(select(select(_e3438, _e3420, _e3453), _e3468, _e3480), _e171, _e3484), select(select(select(_e3439, _e3421, _e3453), _e3469, _e3480), _e182, _e3484));
phi_5803_ = select(1f, 0f, _e3484);
} else {
phi_5802_ = vec3<f32>(_e160, _e171, _e182);
phi_5803_ = 1f;
}
let _e3491 = phi_5802_;
let _e3493 = phi_5803_;
let _e3496 = (_e3395.member * _e3493);
global_5.member[_e117] = (_e128 * (_e3395.member_2.x * _e3496));
global_5.member[_e129] = (_e138 * (_e3395.member_2.y * _e3496));
global_5.member[_e140] = (_e149 * (_e3395.member_2.z * _e3496));
global_5.member[_e151] = _e3491.x;
global_5.member[_e162] = _e3491.y;
global_5.member[_e173] = _e3491.z;
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
