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
var phi_938_: u32;
var phi_3600_: type_29;
var phi_4378_: type_30;
var phi_5343_: type_5;
var phi_6453_: type_31;
var phi_6604_: f32;
var phi_6605_: f32;
var phi_6606_: f32;
var phi_6607_: f32;
let _e83 = global;
let _e86 = arrayLength((&global_2.member));
let _e90 = arrayLength((&global_4.member));
let _e92 = arrayLength((&global_6.member));
let _e97 = global_1.member.member_2;
let _e100 = global_1.member.member;
let _e108 = (_e83.x + _e97.member);
let _e110 = (_e83.y + _e97.member_1);
if (_e108 < _e97.member_2) {
if (_e110 < _e97.member_3) {
let _e113 = (_e100.member * _e100.member_1);
let _e115 = ((_e110 * _e100.member) + _e108);
let _e116 = bitcast<i32>(_e115);
let _e118 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e120 = select(_e118, _e116, (_e116 < _e118));
let _e126 = global_5.member[bitcast<u32>(select(0i, _e120, (_e120 > 0i)))];
let _e127 = (_e113 + _e115);
let _e128 = bitcast<i32>(_e127);
let _e130 = select(_e118, _e128, (_e128 < _e118));
let _e136 = global_5.member[bitcast<u32>(select(0i, _e130, (_e130 > 0i)))];
let _e138 = ((2u * _e113) + _e115);
let _e139 = bitcast<i32>(_e138);
let _e141 = select(_e118, _e139, (_e139 < _e118));
let _e147 = global_5.member[bitcast<u32>(select(0i, _e141, (_e141 > 0i)))];
let _e149 = ((3u * _e113) + _e115);
let _e150 = bitcast<i32>(_e149);
let _e152 = select(_e118, _e150, (_e150 < _e118));
let _e158 = global_5.member[bitcast<u32>(select(0i, _e152, (_e152 > 0i)))];
let _e160 = ((4u * _e113) + _e115);
let _e161 = bitcast<i32>(_e160);
let _e163 = select(_e118, _e161, (_e161 < _e118));
let _e169 = global_5.member[bitcast<u32>(select(0i, _e163, (_e163 > 0i)))];
let _e171 = ((5u * _e113) + _e115);
let _e172 = bitcast<i32>(_e171);
let _e174 = select(_e118, _e172, (_e172 < _e118));
let _e180 = global_5.member[bitcast<u32>(select(0i, _e174, (_e174 > 0i)))];
let _e182 = ((6u * _e113) + _e115);
let _e183 = bitcast<i32>(_e182);
let _e185 = select(_e118, _e183, (_e183 < _e118));
let _e191 = global_5.member[bitcast<u32>(select(0i, _e185, (_e185 > 0i)))];
let _e193 = ((7u * _e113) + _e115);
let _e194 = bitcast<i32>(_e193);
let _e196 = select(_e118, _e194, (_e194 < _e118));
let _e202 = global_5.member[bitcast<u32>(select(0i, _e196, (_e196 > 0i)))];
let _e204 = ((8u * _e113) + _e115);
let _e205 = bitcast<i32>(_e204);
let _e207 = select(_e118, _e205, (_e205 < _e118));
let _e213 = global_5.member[bitcast<u32>(select(0i, _e207, (_e207 > 0i)))];
let _e217 = global_1.member.member_8.member;
let _e221 = global_1.member.member_8.member_1;
let _e222 = (_e217 * _e221);
if (_e92 >= (_e222 * 2u)) {
let _e226 = bitcast<i32>((_e110 * _e217));
let _e228 = bitcast<i32>(_e108);
let _e233 = global_6.member[bitcast<u32>((_e226 + _e228))];
let _e239 = global_6.member[bitcast<u32>(((bitcast<i32>(_e222) + _e226) + _e228))];
let _e240 = f32(_e228);
let _e242 = f32(bitcast<i32>(_e110));
let _e248 = global_1.member.member_5.member;
let _e252 = global_1.member.member_8.member_8;
let _e253 = (_e248 - _e252);
let _e257 = global_1.member.member_8.member_2;
let _e261 = global_1.member.member_8.member_6;
let _e268 = global_1.member.member_8.member_4;
let _e270 = ((_e257 + (_e261 * _e253)) + (((_e240 - _e233) + 0.5f) * _e268));
let _e274 = global_1.member.member_8.member_3;
let _e278 = global_1.member.member_8.member_7;
let _e283 = ((_e274 + (_e278 * _e253)) + (((_e242 - _e239) + 0.5f) * _e268));
let _e287 = global_1.member.member_5.member_1;
let _e288 = (_e287 - _e252);
let _e293 = ((_e257 + (_e261 * _e288)) + ((_e240 + 0.5f) * _e268));
let _e298 = ((_e274 + (_e278 * _e288)) + ((_e242 + 0.5f) * _e268));
let _e302 = global_1.member.member_6.member;
let _e313 = ((((_e302.member.member * _e270) + (_e302.member.member_1 * _e283)) + (_e302.member.member_2 * _e248)) + _e302.member_1);
let _e317 = global_1.member.member_6.member_1;
let _e328 = ((((_e317.member.member * _e270) + (_e317.member.member_1 * _e283)) + (_e317.member.member_2 * _e248)) + _e317.member_1);
let _e332 = global_1.member.member_6.member_2;
let _e343 = ((((_e332.member.member * _e270) + (_e332.member.member_1 * _e283)) + (_e332.member.member_2 * _e248)) + _e332.member_1);
let _e349 = ((((_e302.member.member * _e293) + (_e302.member.member_1 * _e298)) + (_e302.member.member_2 * _e287)) + _e302.member_1);
let _e355 = ((((_e317.member.member * _e293) + (_e317.member.member_1 * _e298)) + (_e317.member.member_2 * _e287)) + _e317.member_1);
let _e361 = ((((_e332.member.member * _e293) + (_e332.member.member_1 * _e298)) + (_e332.member.member_2 * _e287)) + _e332.member_1);
let _e367 = global_1.member.member_6.member_3.member;
let _e368 = (_e367 - 1f);
let _e377 = global_1.member.member_6.member_3.member_1;
let _e378 = (_e377 - 1f);
let _e387 = global_1.member.member_6.member_3.member_2;
let _e388 = (_e387 - 1f);
let _e407 = global_1.member.member_6.member_4;
let _e408 = (_e367 - 0.5f);
let _e410 = select(-0.5f, _e349, (_e349 > -0.5f));
let _e412 = select(_e408, _e410, (_e410 < _e408));
let _e413 = (_e377 - 0.5f);
let _e415 = select(-0.5f, _e355, (_e355 > -0.5f));
let _e417 = select(_e413, _e415, (_e415 < _e413));
let _e418 = (_e387 - 0.5f);
let _e420 = select(-0.5f, _e361, (_e361 > -0.5f));
let _e422 = select(_e418, _e420, (_e420 < _e418));
let _e428 = bitcast<f32>((bitcast<u32>((_e349 - _e313)) & 2147483647u));
let _e431 = bitcast<f32>((bitcast<u32>((_e355 - _e328)) & 2147483647u));
let _e433 = select(_e431, _e428, (_e428 > _e431));
let _e436 = bitcast<f32>((bitcast<u32>((_e361 - _e343)) & 2147483647u));
let _e445 = bitcast<f32>((bitcast<u32>((_e349 - _e412)) & 2147483647u));
let _e448 = bitcast<f32>((bitcast<u32>((_e355 - _e417)) & 2147483647u));
let _e450 = select(_e448, _e445, (_e445 > _e448));
let _e453 = bitcast<f32>((bitcast<u32>((_e361 - _e422)) & 2147483647u));
let _e457 = (_e412 + 0.5f);
let _e459 = select(0f, _e457, (_e457 > 0f));
let _e461 = select(_e368, _e459, (_e459 < _e368));
let _e468 = select(0i, select(select(i32(_e461), i32(-2147483648), (_e461 < -2147483600f)), 2147483647i, (_e461 > 2147483500f)), (_e461 == _e461));
let _e476 = global_1.member.member_6.member_12;
let _e477 = (_e476 & 31u);
let _e480 = (_e417 + 0.5f);
let _e482 = select(0f, _e480, (_e480 > 0f));
let _e484 = select(_e378, _e482, (_e482 < _e378));
let _e491 = select(0i, select(select(i32(_e484), i32(-2147483648), (_e484 < -2147483600f)), 2147483647i, (_e484 > 2147483500f)), (_e484 == _e484));
let _e498 = (_e422 + 0.5f);
let _e500 = select(0f, _e498, (_e498 > 0f));
let _e502 = select(_e388, _e500, (_e500 < _e388));
let _e509 = select(0i, select(select(i32(_e502), i32(-2147483648), (_e502 < -2147483600f)), 2147483647i, (_e502 > 2147483500f)), (_e502 == _e502));
let _e520 = global_1.member.member_6.member_9.member;
let _e526 = global_1.member.member_6.member_9.member_1;
let _e531 = global_1.member.member_6.member_10;
let _e537 = ((bitcast<i32>(_e531) + ((_e468 - select(0i, 1i, (_e461 < f32(_e468)))) >> bitcast<u32>(_e477))) + (bitcast<i32>(_e520) * (((_e491 - select(0i, 1i, (_e484 < f32(_e491)))) >> bitcast<u32>(_e477)) + (bitcast<i32>(_e526) * ((_e509 - select(0i, 1i, (_e502 < f32(_e509)))) >> bitcast<u32>(_e477))))));
let _e539 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e541 = select(_e539, _e537, (_e537 < _e539));
let _e547 = global_3.member[bitcast<u32>(select(0i, _e541, (_e541 > 0i)))];
let _e553 = global_1.member.member_1;
phi_938_ = select(select(7u, 3u, (((((((_e313 >= 0f) && (_e313 <= _e368)) && (_e328 >= 0f)) && (_e328 <= _e378)) && (_e343 >= 0f)) && (_e343 <= _e388)) && ((((((_e349 >= 0f) && (_e349 <= _e368)) && (_e355 >= 0f)) && (_e355 <= _e378)) && (_e361 >= 0f)) && (_e361 <= _e388)))), 1u, (((_e553 & 64u) != 0u) || ((((select(_e436, _e433, (_e433 > _e436)) <= _e407) && ((select(_e453, _e450, (_e450 > _e453)) > _e407) || (_e547 != 0u))) && true) && ((_e553 & 32u) != 0u))));
} else {
phi_938_ = 7u;
}
let _e563 = phi_938_;
if (_e563 > 1u) {
let _e568 = bitcast<i32>(((_e110 * _e217) + _e108));
let _e571 = (bitcast<i32>(_e92) - 1i);
let _e573 = select(_e571, _e568, (_e568 < _e571));
let _e579 = global_6.member[bitcast<u32>(select(0i, _e573, (_e573 > 0i)))];
let _e580 = (bitcast<i32>(_e222) + _e568);
let _e582 = select(_e571, _e580, (_e580 < _e571));
let _e588 = global_6.member[bitcast<u32>(select(0i, _e582, (_e582 > 0i)))];
let _e590 = f32(bitcast<i32>(_e108));
let _e592 = f32(bitcast<i32>(_e110));
let _e598 = global_1.member.member_5.member;
let _e602 = global_1.member.member_8.member_8;
let _e603 = (_e598 - _e602);
let _e607 = global_1.member.member_8.member_2;
let _e611 = global_1.member.member_8.member_6;
let _e618 = global_1.member.member_8.member_4;
let _e620 = ((_e607 + (_e611 * _e603)) + (((_e590 - _e579) + 0.5f) * _e618));
let _e624 = global_1.member.member_8.member_3;
let _e628 = global_1.member.member_8.member_7;
let _e633 = ((_e624 + (_e628 * _e603)) + (((_e592 - _e588) + 0.5f) * _e618));
let _e637 = global_1.member.member_5.member_1;
let _e638 = (_e637 - _e602);
let _e643 = ((_e607 + (_e611 * _e638)) + ((_e590 + 0.5f) * _e618));
let _e648 = ((_e624 + (_e628 * _e638)) + ((_e592 + 0.5f) * _e618));
let _e652 = global_1.member.member_6.member;
let _e663 = ((((_e652.member.member * _e620) + (_e652.member.member_1 * _e633)) + (_e652.member.member_2 * _e598)) + _e652.member_1);
let _e667 = global_1.member.member_6.member_1;
let _e678 = ((((_e667.member.member * _e620) + (_e667.member.member_1 * _e633)) + (_e667.member.member_2 * _e598)) + _e667.member_1);
let _e682 = global_1.member.member_6.member_2;
let _e693 = ((((_e682.member.member * _e620) + (_e682.member.member_1 * _e633)) + (_e682.member.member_2 * _e598)) + _e682.member_1);
let _e699 = ((((_e652.member.member * _e643) + (_e652.member.member_1 * _e648)) + (_e652.member.member_2 * _e637)) + _e652.member_1);
let _e705 = ((((_e667.member.member * _e643) + (_e667.member.member_1 * _e648)) + (_e667.member.member_2 * _e637)) + _e667.member_1);
let _e711 = ((((_e682.member.member * _e643) + (_e682.member.member_1 * _e648)) + (_e682.member.member_2 * _e637)) + _e682.member_1);
let _e713 = (_e100.member_2 == 2u);
let _e716 = (((_e100.member_2 == 1u) || _e713) || (_e100.member_2 == 5u));
if _e716 {
let _e721 = global_1.member.member_6.member_3.member;
let _e722 = (_e721 - 0.5f);
let _e724 = select(-0.5f, _e699, (_e699 > -0.5f));
let _e726 = select(_e722, _e724, (_e724 < _e722));
let _e731 = global_1.member.member_6.member_3.member_1;
let _e732 = (_e731 - 0.5f);
let _e734 = select(-0.5f, _e705, (_e705 > -0.5f));
let _e736 = select(_e732, _e734, (_e734 < _e732));
let _e741 = global_1.member.member_6.member_3.member_2;
let _e742 = (_e741 - 0.5f);
let _e744 = select(-0.5f, _e711, (_e711 > -0.5f));
let _e746 = select(_e742, _e744, (_e744 < _e742));
let _e748 = select(-1f, _e726, (_e726 > -1f));
let _e750 = select(_e721, _e748, (_e748 < _e721));
let _e757 = select(0i, select(select(i32(_e750), i32(-2147483648), (_e750 < -2147483600f)), 2147483647i, (_e750 > 2147483500f)), (_e750 == _e750));
let _e761 = (_e757 - select(0i, 1i, (_e750 < f32(_e757))));
let _e763 = select(-1f, _e736, (_e736 > -1f));
let _e765 = select(_e731, _e763, (_e763 < _e731));
let _e772 = select(0i, select(select(i32(_e765), i32(-2147483648), (_e765 < -2147483600f)), 2147483647i, (_e765 > 2147483500f)), (_e765 == _e765));
let _e776 = (_e772 - select(0i, 1i, (_e765 < f32(_e772))));
let _e778 = select(-1f, _e746, (_e746 > -1f));
let _e780 = select(_e741, _e778, (_e778 < _e741));
let _e787 = select(0i, select(select(i32(_e780), i32(-2147483648), (_e780 < -2147483600f)), 2147483647i, (_e780 > 2147483500f)), (_e780 == _e780));
let _e791 = (_e787 - select(0i, 1i, (_e780 < f32(_e787))));
let _e795 = global_1.member.member_6.member_7;
let _e799 = global_1.member.member_6.member_8;
let _e807 = (select(0i, select(select(i32(_e731), i32(-2147483648), (_e731 < -2147483600f)), 2147483647i, (_e731 > 2147483500f)), (_e731 == _e731)) - 1i);
let _e808 = (_e776 - 1i);
let _e813 = (_e776 + 1i);
let _e816 = (_e776 + 2i);
let _e826 = (select(0i, select(select(i32(_e741), i32(-2147483648), (_e741 < -2147483600f)), 2147483647i, (_e741 > 2147483500f)), (_e741 == _e741)) - 1i);
let _e827 = (_e791 - 1i);
let _e832 = (_e791 + 1i);
let _e835 = (_e791 + 2i);
let _e844 = select(0i, select(select(i32(_e721), i32(-2147483648), (_e721 < -2147483600f)), 2147483647i, (_e721 > 2147483500f)), (_e721 == _e721));
let _e845 = (_e844 - 1i);
let _e846 = (_e761 - 1i);
let _e848 = select(0i, _e846, (_e846 > 0i));
let _e850 = select(0i, _e761, (_e761 > 0i));
let _e851 = (_e761 + 1i);
let _e853 = select(_e845, _e851, (_e851 < _e845));
let _e854 = (_e761 + 2i);
let _e857 = (_e844 - 2i);
let _e859 = select(0i, _e857, (_e857 > 0i));
let _e861 = select(_e859, _e848, (_e848 < _e859));
let _e863 = select(_e859, _e850, (_e850 < _e859));
let _e865 = select(_e859, _e853, (_e853 < _e859));
let _e884 = (select(0i, _e808, (_e808 > 0i)) * _e795);
let _e885 = (select(0i, _e776, (_e776 > 0i)) * _e795);
let _e886 = (select(_e807, _e813, (_e813 < _e807)) * _e795);
let _e887 = (select(_e807, _e816, (_e816 < _e807)) * _e795);
let _e888 = (select(0i, _e827, (_e827 > 0i)) * _e799);
let _e889 = (select(0i, _e791, (_e791 > 0i)) * _e799);
let _e890 = (select(_e826, _e832, (_e832 < _e826)) * _e799);
let _e891 = (select(_e826, _e835, (_e835 < _e826)) * _e799);
local_4 = type_28(array<i32, 4>(_e861, _e863, _e865, 0i), array<u32, 6>(bitcast<u32>(((_e848 - _e861) * 16i)), bitcast<u32>(((_e850 - _e861) * 16i)), bitcast<u32>(((_e850 - _e863) * 16i)), bitcast<u32>(((_e853 - _e863) * 16i)), bitcast<u32>(((_e853 - _e865) * 16i)), bitcast<u32>(((select(_e845, _e854, (_e854 < _e845)) - _e865) * 16i))));
local_5 = vec3<f32>((_e726 - f32(_e761)), (_e736 - f32(_e776)), (_e746 - f32(_e791)));
let _e903 = (_e889 + _e885);
let _e906 = local_4.member[0u];
let _e907 = (_e903 + _e906);
let _e909 = (_e907 >> bitcast<u32>(1i));
let _e912 = bitcast<u32>(((_e907 & 1i) * 16i));
let _e914 = (bitcast<i32>(_e86) - 1i);
let _e916 = select(_e914, _e909, (_e909 < _e914));
let _e921 = global_2.member[bitcast<u32>(select(0i, _e916, (_e916 > 0i)))];
let _e925 = (_e909 + 1i);
let _e927 = select(_e914, _e925, (_e925 < _e914));
let _e932 = global_2.member[bitcast<u32>(select(0i, _e927, (_e927 > 0i)))];
let _e939 = ((_e921 >> bitcast<u32>((_e912 & 31u))) | ((_e932 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e912) & 31u))));
let _e942 = local_4.member[2u];
let _e943 = (_e903 + _e942);
let _e945 = (_e943 >> bitcast<u32>(1i));
let _e948 = bitcast<u32>(((_e943 & 1i) * 16i));
let _e950 = select(_e914, _e945, (_e945 < _e914));
let _e955 = global_2.member[bitcast<u32>(select(0i, _e950, (_e950 > 0i)))];
let _e959 = (_e945 + 1i);
let _e961 = select(_e914, _e959, (_e959 < _e914));
let _e966 = global_2.member[bitcast<u32>(select(0i, _e961, (_e961 > 0i)))];
let _e973 = ((_e955 >> bitcast<u32>((_e948 & 31u))) | ((_e966 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e948) & 31u))));
let _e976 = local_4.member_1[0u];
let _e982 = f32(bitcast<i32>(((_e939 >> bitcast<u32>((_e976 & 31u))) & 65535u)));
let _e985 = local_4.member_1[1u];
let _e991 = f32(bitcast<i32>(((_e939 >> bitcast<u32>((_e985 & 31u))) & 65535u)));
let _e994 = local_4.member_1[4u];
let _e1000 = f32(bitcast<i32>(((_e973 >> bitcast<u32>((_e994 & 31u))) & 65535u)));
let _e1003 = local_4.member_1[5u];
let _e1010 = local_5[0u];
let _e1013 = (_e982 + ((_e991 - _e982) * _e1010));
let _e1014 = local_5[0u];
let _e1017 = (_e991 + ((_e1000 - _e991) * _e1014));
let _e1018 = local_5[0u];
let _e1021 = (_e1000 + ((f32(bitcast<i32>(((_e973 >> bitcast<u32>((_e1003 & 31u))) & 65535u))) - _e1000) * _e1018));
let _e1022 = (_e889 + _e886);
let _e1023 = local_4.member[0u];
let _e1024 = (_e1022 + _e1023);
let _e1026 = (_e1024 >> bitcast<u32>(1i));
let _e1029 = bitcast<u32>(((_e1024 & 1i) * 16i));
let _e1031 = select(_e914, _e1026, (_e1026 < _e914));
let _e1036 = global_2.member[bitcast<u32>(select(0i, _e1031, (_e1031 > 0i)))];
let _e1040 = (_e1026 + 1i);
let _e1042 = select(_e914, _e1040, (_e1040 < _e914));
let _e1047 = global_2.member[bitcast<u32>(select(0i, _e1042, (_e1042 > 0i)))];
let _e1054 = ((_e1036 >> bitcast<u32>((_e1029 & 31u))) | ((_e1047 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1029) & 31u))));
let _e1055 = local_4.member[2u];
let _e1056 = (_e1022 + _e1055);
let _e1058 = (_e1056 >> bitcast<u32>(1i));
let _e1061 = bitcast<u32>(((_e1056 & 1i) * 16i));
let _e1063 = select(_e914, _e1058, (_e1058 < _e914));
let _e1068 = global_2.member[bitcast<u32>(select(0i, _e1063, (_e1063 > 0i)))];
let _e1072 = (_e1058 + 1i);
let _e1074 = select(_e914, _e1072, (_e1072 < _e914));
let _e1079 = global_2.member[bitcast<u32>(select(0i, _e1074, (_e1074 > 0i)))];
let _e1086 = ((_e1068 >> bitcast<u32>((_e1061 & 31u))) | ((_e1079 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1061) & 31u))));
let _e1087 = local_4.member_1[0u];
let _e1093 = f32(bitcast<i32>(((_e1054 >> bitcast<u32>((_e1087 & 31u))) & 65535u)));
let _e1094 = local_4.member_1[1u];
let _e1100 = f32(bitcast<i32>(((_e1054 >> bitcast<u32>((_e1094 & 31u))) & 65535u)));
let _e1101 = local_4.member_1[4u];
let _e1107 = f32(bitcast<i32>(((_e1086 >> bitcast<u32>((_e1101 & 31u))) & 65535u)));
let _e1108 = local_4.member_1[5u];
let _e1115 = local_5[0u];
let _e1119 = local_5[0u];
let _e1122 = (_e1100 + ((_e1107 - _e1100) * _e1119));
let _e1123 = local_5[0u];
let _e1127 = (_e890 + _e885);
let _e1128 = local_4.member[0u];
let _e1129 = (_e1127 + _e1128);
let _e1131 = (_e1129 >> bitcast<u32>(1i));
let _e1134 = bitcast<u32>(((_e1129 & 1i) * 16i));
let _e1136 = select(_e914, _e1131, (_e1131 < _e914));
let _e1141 = global_2.member[bitcast<u32>(select(0i, _e1136, (_e1136 > 0i)))];
let _e1145 = (_e1131 + 1i);
let _e1147 = select(_e914, _e1145, (_e1145 < _e914));
let _e1152 = global_2.member[bitcast<u32>(select(0i, _e1147, (_e1147 > 0i)))];
let _e1159 = ((_e1141 >> bitcast<u32>((_e1134 & 31u))) | ((_e1152 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1134) & 31u))));
let _e1160 = local_4.member[2u];
let _e1161 = (_e1127 + _e1160);
let _e1163 = (_e1161 >> bitcast<u32>(1i));
let _e1166 = bitcast<u32>(((_e1161 & 1i) * 16i));
let _e1168 = select(_e914, _e1163, (_e1163 < _e914));
let _e1173 = global_2.member[bitcast<u32>(select(0i, _e1168, (_e1168 > 0i)))];
let _e1177 = (_e1163 + 1i);
let _e1179 = select(_e914, _e1177, (_e1177 < _e914));
let _e1184 = global_2.member[bitcast<u32>(select(0i, _e1179, (_e1179 > 0i)))];
let _e1191 = ((_e1173 >> bitcast<u32>((_e1166 & 31u))) | ((_e1184 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1166) & 31u))));
let _e1192 = local_4.member_1[0u];
let _e1198 = f32(bitcast<i32>(((_e1159 >> bitcast<u32>((_e1192 & 31u))) & 65535u)));
let _e1199 = local_4.member_1[1u];
let _e1205 = f32(bitcast<i32>(((_e1159 >> bitcast<u32>((_e1199 & 31u))) & 65535u)));
let _e1206 = local_4.member_1[4u];
let _e1212 = f32(bitcast<i32>(((_e1191 >> bitcast<u32>((_e1206 & 31u))) & 65535u)));
let _e1213 = local_4.member_1[5u];
let _e1220 = local_5[0u];
let _e1223 = (_e1198 + ((_e1205 - _e1198) * _e1220));
let _e1224 = local_5[0u];
let _e1227 = (_e1205 + ((_e1212 - _e1205) * _e1224));
let _e1228 = local_5[0u];
let _e1231 = (_e1212 + ((f32(bitcast<i32>(((_e1191 >> bitcast<u32>((_e1213 & 31u))) & 65535u))) - _e1212) * _e1228));
let _e1232 = (_e890 + _e886);
let _e1233 = local_4.member[0u];
let _e1234 = (_e1232 + _e1233);
let _e1236 = (_e1234 >> bitcast<u32>(1i));
let _e1239 = bitcast<u32>(((_e1234 & 1i) * 16i));
let _e1241 = select(_e914, _e1236, (_e1236 < _e914));
let _e1246 = global_2.member[bitcast<u32>(select(0i, _e1241, (_e1241 > 0i)))];
let _e1250 = (_e1236 + 1i);
let _e1252 = select(_e914, _e1250, (_e1250 < _e914));
let _e1257 = global_2.member[bitcast<u32>(select(0i, _e1252, (_e1252 > 0i)))];
let _e1264 = ((_e1246 >> bitcast<u32>((_e1239 & 31u))) | ((_e1257 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1239) & 31u))));
let _e1265 = local_4.member[2u];
let _e1266 = (_e1232 + _e1265);
let _e1268 = (_e1266 >> bitcast<u32>(1i));
let _e1271 = bitcast<u32>(((_e1266 & 1i) * 16i));
let _e1273 = select(_e914, _e1268, (_e1268 < _e914));
let _e1278 = global_2.member[bitcast<u32>(select(0i, _e1273, (_e1273 > 0i)))];
let _e1282 = (_e1268 + 1i);
let _e1284 = select(_e914, _e1282, (_e1282 < _e914));
let _e1289 = global_2.member[bitcast<u32>(select(0i, _e1284, (_e1284 > 0i)))];
let _e1296 = ((_e1278 >> bitcast<u32>((_e1271 & 31u))) | ((_e1289 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1271) & 31u))));
let _e1297 = local_4.member_1[0u];
let _e1303 = f32(bitcast<i32>(((_e1264 >> bitcast<u32>((_e1297 & 31u))) & 65535u)));
let _e1304 = local_4.member_1[1u];
let _e1310 = f32(bitcast<i32>(((_e1264 >> bitcast<u32>((_e1304 & 31u))) & 65535u)));
let _e1311 = local_4.member_1[4u];
let _e1317 = f32(bitcast<i32>(((_e1296 >> bitcast<u32>((_e1311 & 31u))) & 65535u)));
let _e1318 = local_4.member_1[5u];
let _e1325 = local_5[0u];
let _e1329 = local_5[0u];
let _e1332 = (_e1310 + ((_e1317 - _e1310) * _e1329));
let _e1333 = local_5[0u];
let _e1340 = local_4.member[1u];
let _e1341 = ((_e889 + _e884) + _e1340);
let _e1343 = (_e1341 >> bitcast<u32>(1i));
let _e1346 = bitcast<u32>(((_e1341 & 1i) * 16i));
let _e1348 = select(_e914, _e1343, (_e1343 < _e914));
let _e1353 = global_2.member[bitcast<u32>(select(0i, _e1348, (_e1348 > 0i)))];
let _e1357 = (_e1343 + 1i);
let _e1359 = select(_e914, _e1357, (_e1357 < _e914));
let _e1364 = global_2.member[bitcast<u32>(select(0i, _e1359, (_e1359 > 0i)))];
let _e1371 = ((_e1353 >> bitcast<u32>((_e1346 & 31u))) | ((_e1364 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1346) & 31u))));
let _e1374 = local_4.member_1[2u];
let _e1380 = f32(bitcast<i32>(((_e1371 >> bitcast<u32>((_e1374 & 31u))) & 65535u)));
let _e1383 = local_4.member_1[3u];
let _e1390 = local_5[0u];
let _e1393 = (_e1380 + ((f32(bitcast<i32>(((_e1371 >> bitcast<u32>((_e1383 & 31u))) & 65535u))) - _e1380) * _e1390));
let _e1395 = local_4.member[1u];
let _e1396 = ((_e889 + _e887) + _e1395);
let _e1398 = (_e1396 >> bitcast<u32>(1i));
let _e1401 = bitcast<u32>(((_e1396 & 1i) * 16i));
let _e1403 = select(_e914, _e1398, (_e1398 < _e914));
let _e1408 = global_2.member[bitcast<u32>(select(0i, _e1403, (_e1403 > 0i)))];
let _e1412 = (_e1398 + 1i);
let _e1414 = select(_e914, _e1412, (_e1412 < _e914));
let _e1419 = global_2.member[bitcast<u32>(select(0i, _e1414, (_e1414 > 0i)))];
let _e1426 = ((_e1408 >> bitcast<u32>((_e1401 & 31u))) | ((_e1419 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1401) & 31u))));
let _e1427 = local_4.member_1[2u];
let _e1433 = f32(bitcast<i32>(((_e1426 >> bitcast<u32>((_e1427 & 31u))) & 65535u)));
let _e1434 = local_4.member_1[3u];
let _e1441 = local_5[0u];
let _e1446 = local_4.member[1u];
let _e1447 = ((_e890 + _e884) + _e1446);
let _e1449 = (_e1447 >> bitcast<u32>(1i));
let _e1452 = bitcast<u32>(((_e1447 & 1i) * 16i));
let _e1454 = select(_e914, _e1449, (_e1449 < _e914));
let _e1459 = global_2.member[bitcast<u32>(select(0i, _e1454, (_e1454 > 0i)))];
let _e1463 = (_e1449 + 1i);
let _e1465 = select(_e914, _e1463, (_e1463 < _e914));
let _e1470 = global_2.member[bitcast<u32>(select(0i, _e1465, (_e1465 > 0i)))];
let _e1477 = ((_e1459 >> bitcast<u32>((_e1452 & 31u))) | ((_e1470 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1452) & 31u))));
let _e1478 = local_4.member_1[2u];
let _e1484 = f32(bitcast<i32>(((_e1477 >> bitcast<u32>((_e1478 & 31u))) & 65535u)));
let _e1485 = local_4.member_1[3u];
let _e1492 = local_5[0u];
let _e1495 = (_e1484 + ((f32(bitcast<i32>(((_e1477 >> bitcast<u32>((_e1485 & 31u))) & 65535u))) - _e1484) * _e1492));
let _e1497 = local_4.member[1u];
let _e1498 = ((_e890 + _e887) + _e1497);
let _e1500 = (_e1498 >> bitcast<u32>(1i));
let _e1503 = bitcast<u32>(((_e1498 & 1i) * 16i));
let _e1505 = select(_e914, _e1500, (_e1500 < _e914));
let _e1510 = global_2.member[bitcast<u32>(select(0i, _e1505, (_e1505 > 0i)))];
let _e1514 = (_e1500 + 1i);
let _e1516 = select(_e914, _e1514, (_e1514 < _e914));
let _e1521 = global_2.member[bitcast<u32>(select(0i, _e1516, (_e1516 > 0i)))];
let _e1528 = ((_e1510 >> bitcast<u32>((_e1503 & 31u))) | ((_e1521 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1503) & 31u))));
let _e1529 = local_4.member_1[2u];
let _e1535 = f32(bitcast<i32>(((_e1528 >> bitcast<u32>((_e1529 & 31u))) & 65535u)));
let _e1536 = local_4.member_1[3u];
let _e1543 = local_5[0u];
let _e1548 = local_4.member[1u];
let _e1549 = ((_e888 + _e885) + _e1548);
let _e1551 = (_e1549 >> bitcast<u32>(1i));
let _e1554 = bitcast<u32>(((_e1549 & 1i) * 16i));
let _e1556 = select(_e914, _e1551, (_e1551 < _e914));
let _e1561 = global_2.member[bitcast<u32>(select(0i, _e1556, (_e1556 > 0i)))];
let _e1565 = (_e1551 + 1i);
let _e1567 = select(_e914, _e1565, (_e1565 < _e914));
let _e1572 = global_2.member[bitcast<u32>(select(0i, _e1567, (_e1567 > 0i)))];
let _e1579 = ((_e1561 >> bitcast<u32>((_e1554 & 31u))) | ((_e1572 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1554) & 31u))));
let _e1580 = local_4.member_1[2u];
let _e1586 = f32(bitcast<i32>(((_e1579 >> bitcast<u32>((_e1580 & 31u))) & 65535u)));
let _e1587 = local_4.member_1[3u];
let _e1594 = local_5[0u];
let _e1597 = (_e1586 + ((f32(bitcast<i32>(((_e1579 >> bitcast<u32>((_e1587 & 31u))) & 65535u))) - _e1586) * _e1594));
let _e1599 = local_4.member[1u];
let _e1600 = ((_e891 + _e885) + _e1599);
let _e1602 = (_e1600 >> bitcast<u32>(1i));
let _e1605 = bitcast<u32>(((_e1600 & 1i) * 16i));
let _e1607 = select(_e914, _e1602, (_e1602 < _e914));
let _e1612 = global_2.member[bitcast<u32>(select(0i, _e1607, (_e1607 > 0i)))];
let _e1616 = (_e1602 + 1i);
let _e1618 = select(_e914, _e1616, (_e1616 < _e914));
let _e1623 = global_2.member[bitcast<u32>(select(0i, _e1618, (_e1618 > 0i)))];
let _e1630 = ((_e1612 >> bitcast<u32>((_e1605 & 31u))) | ((_e1623 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1605) & 31u))));
let _e1631 = local_4.member_1[2u];
let _e1637 = f32(bitcast<i32>(((_e1630 >> bitcast<u32>((_e1631 & 31u))) & 65535u)));
let _e1638 = local_4.member_1[3u];
let _e1645 = local_5[0u];
let _e1648 = (_e1637 + ((f32(bitcast<i32>(((_e1630 >> bitcast<u32>((_e1638 & 31u))) & 65535u))) - _e1637) * _e1645));
let _e1650 = local_4.member[1u];
let _e1651 = ((_e888 + _e886) + _e1650);
let _e1653 = (_e1651 >> bitcast<u32>(1i));
let _e1656 = bitcast<u32>(((_e1651 & 1i) * 16i));
let _e1658 = select(_e914, _e1653, (_e1653 < _e914));
let _e1663 = global_2.member[bitcast<u32>(select(0i, _e1658, (_e1658 > 0i)))];
let _e1667 = (_e1653 + 1i);
let _e1669 = select(_e914, _e1667, (_e1667 < _e914));
let _e1674 = global_2.member[bitcast<u32>(select(0i, _e1669, (_e1669 > 0i)))];
let _e1681 = ((_e1663 >> bitcast<u32>((_e1656 & 31u))) | ((_e1674 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1656) & 31u))));
let _e1682 = local_4.member_1[2u];
let _e1688 = f32(bitcast<i32>(((_e1681 >> bitcast<u32>((_e1682 & 31u))) & 65535u)));
let _e1689 = local_4.member_1[3u];
let _e1696 = local_5[0u];
let _e1701 = local_4.member[1u];
let _e1702 = ((_e891 + _e886) + _e1701);
let _e1704 = (_e1702 >> bitcast<u32>(1i));
let _e1707 = bitcast<u32>(((_e1702 & 1i) * 16i));
let _e1709 = select(_e914, _e1704, (_e1704 < _e914));
let _e1714 = global_2.member[bitcast<u32>(select(0i, _e1709, (_e1709 > 0i)))];
let _e1718 = (_e1704 + 1i);
let _e1720 = select(_e914, _e1718, (_e1718 < _e914));
let _e1725 = global_2.member[bitcast<u32>(select(0i, _e1720, (_e1720 > 0i)))];
let _e1732 = ((_e1714 >> bitcast<u32>((_e1707 & 31u))) | ((_e1725 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1707) & 31u))));
let _e1733 = local_4.member_1[2u];
let _e1739 = f32(bitcast<i32>(((_e1732 >> bitcast<u32>((_e1733 & 31u))) & 65535u)));
let _e1740 = local_4.member_1[3u];
let _e1747 = local_5[0u];
let _e1752 = local_5[1u];
let _e1755 = (_e1017 + ((_e1122 - _e1017) * _e1752));
let _e1756 = local_5[1u];
let _e1759 = (_e1227 + ((_e1332 - _e1227) * _e1756));
let _e1760 = local_5[1u];
let _e1763 = (_e1013 + (((_e1093 + ((_e1100 - _e1093) * _e1115)) - _e1013) * _e1760));
let _e1764 = local_5[1u];
let _e1769 = local_5[2u];
let _e1773 = local_5[1u];
let _e1776 = (_e1021 + (((_e1107 + ((f32(bitcast<i32>(((_e1086 >> bitcast<u32>((_e1108 & 31u))) & 65535u))) - _e1107) * _e1123)) - _e1021) * _e1773));
let _e1777 = local_5[1u];
let _e1781 = local_5[2u];
let _e1785 = local_5[1u];
let _e1788 = (_e1393 + ((_e1017 - _e1393) * _e1785));
let _e1789 = local_5[1u];
let _e1793 = local_5[2u];
let _e1797 = local_5[1u];
let _e1800 = (_e1122 + (((_e1433 + ((f32(bitcast<i32>(((_e1426 >> bitcast<u32>((_e1434 & 31u))) & 65535u))) - _e1433) * _e1441)) - _e1122) * _e1797));
let _e1801 = local_5[1u];
let _e1805 = local_5[2u];
let _e1809 = local_5[1u];
let _e1812 = (_e1597 + (((_e1688 + ((f32(bitcast<i32>(((_e1681 >> bitcast<u32>((_e1689 & 31u))) & 65535u))) - _e1688) * _e1696)) - _e1597) * _e1809));
let _e1813 = local_5[2u];
let _e1817 = local_5[1u];
let _e1821 = local_5[2u];
let _e1825 = local_5[2u];
let _e1832 = global_1.member.member_6.member_5;
let _e1837 = global_1.member.member_6.member_6;
let _e1838 = (((_e1755 + ((_e1759 - _e1755) * _e1825)) * _e1832) + _e1837);
let _e1840 = select(0f, _e1838, (_e1838 > 0f));
let _e1842 = select(1f, _e1840, (_e1840 < 1f));
let _e1844 = (((_e1763 + (((_e1223 + (((_e1303 + ((_e1310 - _e1303) * _e1325)) - _e1223) * _e1764)) - _e1763) * _e1769)) * _e1832) + _e1837);
let _e1846 = select(0f, _e1844, (_e1844 > 0f));
let _e1848 = select(1f, _e1846, (_e1846 < 1f));
let _e1850 = (((_e1776 + (((_e1231 + (((_e1317 + ((f32(bitcast<i32>(((_e1296 >> bitcast<u32>((_e1318 & 31u))) & 65535u))) - _e1317) * _e1333)) - _e1231) * _e1777)) - _e1776) * _e1781)) * _e1832) + _e1837);
let _e1852 = select(0f, _e1850, (_e1850 > 0f));
let _e1854 = select(1f, _e1852, (_e1852 < 1f));
let _e1856 = (((_e1788 + (((_e1495 + ((_e1227 - _e1495) * _e1789)) - _e1788) * _e1793)) * _e1832) + _e1837);
let _e1858 = select(0f, _e1856, (_e1856 > 0f));
let _e1860 = select(1f, _e1858, (_e1858 < 1f));
let _e1862 = (((_e1800 + (((_e1332 + (((_e1535 + ((f32(bitcast<i32>(((_e1528 >> bitcast<u32>((_e1536 & 31u))) & 65535u))) - _e1535) * _e1543)) - _e1332) * _e1801)) - _e1800) * _e1805)) * _e1832) + _e1837);
let _e1864 = select(0f, _e1862, (_e1862 > 0f));
let _e1866 = select(1f, _e1864, (_e1864 < 1f));
let _e1868 = (((_e1812 + ((_e1755 - _e1812) * _e1813)) * _e1832) + _e1837);
let _e1870 = select(0f, _e1868, (_e1868 > 0f));
let _e1872 = select(1f, _e1870, (_e1870 < 1f));
let _e1874 = (((_e1759 + (((_e1648 + (((_e1739 + ((f32(bitcast<i32>(((_e1732 >> bitcast<u32>((_e1740 & 31u))) & 65535u))) - _e1739) * _e1747)) - _e1648) * _e1817)) - _e1759) * _e1821)) * _e1832) + _e1837);
let _e1876 = select(0f, _e1874, (_e1874 > 0f));
let _e1878 = select(1f, _e1876, (_e1876 < 1f));
let _e1879 = (_e1842 * 1024f);
let _e1880 = (1024f - 1f);
let _e1882 = select(0f, _e1879, (_e1879 > 0f));
let _e1884 = select(_e1880, _e1882, (_e1882 < _e1880));
let _e1891 = select(0i, select(select(i32(_e1884), i32(-2147483648), (_e1884 < -2147483600f)), 2147483647i, (_e1884 > 2147483500f)), (_e1884 == _e1884));
let _e1895 = (_e1891 - select(0i, 1i, (_e1884 < f32(_e1891))));
let _e1896 = (262147i + _e1895);
let _e1898 = (bitcast<i32>(_e90) - 1i);
let _e1900 = select(_e1898, _e1896, (_e1896 < _e1898));
let _e1906 = global_4.member[bitcast<u32>(select(0i, _e1900, (_e1900 > 0i)))];
let _e1916 = select(_e1898, 262146i, (262146i < _e1898));
let _e1922 = global_4.member[bitcast<u32>(select(0i, _e1916, (_e1916 > 0i)))];
let _e1923 = bitcast<f32>(_e1922);
let _e1924 = (f32((bitcast<i32>((_e1906 & 4095u)) - 2048i)) * _e1923);
let _e1926 = select(_e1898, 262144i, (262144i < _e1898));
let _e1932 = global_4.member[bitcast<u32>(select(0i, _e1926, (_e1926 > 0i)))];
let _e1933 = bitcast<f32>(_e1932);
let _e1935 = select(_e1898, 262145i, (262145i < _e1898));
let _e1941 = global_4.member[bitcast<u32>(select(0i, _e1935, (_e1935 > 0i)))];
let _e1942 = bitcast<f32>(_e1941);
let _e1948 = ((_e1933 + (f32(bitcast<i32>((_e1906 >> bitcast<u32>(12u)))) * _e1942)) + (_e1924 * (_e1879 - f32(_e1895))));
let _e1949 = (_e1924 * 1024f);
if _e713 {
let _e1956 = ((0.5f * (_e1854 - _e1848)) * _e1949);
let _e1957 = ((0.5f * (_e1866 - _e1860)) * _e1949);
let _e1958 = ((0.5f * (_e1878 - _e1872)) * _e1949);
phi_3600_ = type_29(_e1948, vec3<f32>(_e1956, _e1957, _e1958), vec3<f32>((_e1956 * _e1948), (_e1957 * _e1948), (_e1958 * _e1948)));
} else {
let _e1965 = (_e1848 * 1024f);
let _e1967 = select(0f, _e1965, (_e1965 > 0f));
let _e1969 = select(_e1880, _e1967, (_e1967 < _e1880));
let _e1976 = select(0i, select(select(i32(_e1969), i32(-2147483648), (_e1969 < -2147483600f)), 2147483647i, (_e1969 > 2147483500f)), (_e1969 == _e1969));
let _e1980 = (_e1976 - select(0i, 1i, (_e1969 < f32(_e1976))));
let _e1981 = (262147i + _e1980);
let _e1983 = select(_e1898, _e1981, (_e1981 < _e1898));
let _e1989 = global_4.member[bitcast<u32>(select(0i, _e1983, (_e1983 > 0i)))];
let _e2004 = ((_e1933 + (f32(bitcast<i32>((_e1989 >> bitcast<u32>(12u)))) * _e1942)) + ((f32((bitcast<i32>((_e1989 & 4095u)) - 2048i)) * _e1923) * (_e1965 - f32(_e1980))));
let _e2005 = (_e1854 * 1024f);
let _e2007 = select(0f, _e2005, (_e2005 > 0f));
let _e2009 = select(_e1880, _e2007, (_e2007 < _e1880));
let _e2016 = select(0i, select(select(i32(_e2009), i32(-2147483648), (_e2009 < -2147483600f)), 2147483647i, (_e2009 > 2147483500f)), (_e2009 == _e2009));
let _e2020 = (_e2016 - select(0i, 1i, (_e2009 < f32(_e2016))));
let _e2021 = (262147i + _e2020);
let _e2023 = select(_e1898, _e2021, (_e2021 < _e1898));
let _e2029 = global_4.member[bitcast<u32>(select(0i, _e2023, (_e2023 > 0i)))];
let _e2044 = ((_e1933 + (f32(bitcast<i32>((_e2029 >> bitcast<u32>(12u)))) * _e1942)) + ((f32((bitcast<i32>((_e2029 & 4095u)) - 2048i)) * _e1923) * (_e2005 - f32(_e2020))));
let _e2045 = (_e1860 * 1024f);
let _e2047 = select(0f, _e2045, (_e2045 > 0f));
let _e2049 = select(_e1880, _e2047, (_e2047 < _e1880));
let _e2056 = select(0i, select(select(i32(_e2049), i32(-2147483648), (_e2049 < -2147483600f)), 2147483647i, (_e2049 > 2147483500f)), (_e2049 == _e2049));
let _e2060 = (_e2056 - select(0i, 1i, (_e2049 < f32(_e2056))));
let _e2061 = (262147i + _e2060);
let _e2063 = select(_e1898, _e2061, (_e2061 < _e1898));
let _e2069 = global_4.member[bitcast<u32>(select(0i, _e2063, (_e2063 > 0i)))];
let _e2084 = ((_e1933 + (f32(bitcast<i32>((_e2069 >> bitcast<u32>(12u)))) * _e1942)) + ((f32((bitcast<i32>((_e2069 & 4095u)) - 2048i)) * _e1923) * (_e2045 - f32(_e2060))));
let _e2085 = (_e1866 * 1024f);
let _e2087 = select(0f, _e2085, (_e2085 > 0f));
let _e2089 = select(_e1880, _e2087, (_e2087 < _e1880));
let _e2096 = select(0i, select(select(i32(_e2089), i32(-2147483648), (_e2089 < -2147483600f)), 2147483647i, (_e2089 > 2147483500f)), (_e2089 == _e2089));
let _e2100 = (_e2096 - select(0i, 1i, (_e2089 < f32(_e2096))));
let _e2101 = (262147i + _e2100);
let _e2103 = select(_e1898, _e2101, (_e2101 < _e1898));
let _e2109 = global_4.member[bitcast<u32>(select(0i, _e2103, (_e2103 > 0i)))];
let _e2124 = ((_e1933 + (f32(bitcast<i32>((_e2109 >> bitcast<u32>(12u)))) * _e1942)) + ((f32((bitcast<i32>((_e2109 & 4095u)) - 2048i)) * _e1923) * (_e2085 - f32(_e2100))));
let _e2125 = (_e1872 * 1024f);
let _e2127 = select(0f, _e2125, (_e2125 > 0f));
let _e2129 = select(_e1880, _e2127, (_e2127 < _e1880));
let _e2136 = select(0i, select(select(i32(_e2129), i32(-2147483648), (_e2129 < -2147483600f)), 2147483647i, (_e2129 > 2147483500f)), (_e2129 == _e2129));
let _e2140 = (_e2136 - select(0i, 1i, (_e2129 < f32(_e2136))));
let _e2141 = (262147i + _e2140);
let _e2143 = select(_e1898, _e2141, (_e2141 < _e1898));
let _e2149 = global_4.member[bitcast<u32>(select(0i, _e2143, (_e2143 > 0i)))];
let _e2164 = ((_e1933 + (f32(bitcast<i32>((_e2149 >> bitcast<u32>(12u)))) * _e1942)) + ((f32((bitcast<i32>((_e2149 & 4095u)) - 2048i)) * _e1923) * (_e2125 - f32(_e2140))));
let _e2165 = (_e1878 * 1024f);
let _e2167 = select(0f, _e2165, (_e2165 > 0f));
let _e2169 = select(_e1880, _e2167, (_e2167 < _e1880));
let _e2176 = select(0i, select(select(i32(_e2169), i32(-2147483648), (_e2169 < -2147483600f)), 2147483647i, (_e2169 > 2147483500f)), (_e2169 == _e2169));
let _e2180 = (_e2176 - select(0i, 1i, (_e2169 < f32(_e2176))));
let _e2181 = (262147i + _e2180);
let _e2183 = select(_e1898, _e2181, (_e2181 < _e1898));
let _e2189 = global_4.member[bitcast<u32>(select(0i, _e2183, (_e2183 > 0i)))];
let _e2204 = ((_e1933 + (f32(bitcast<i32>((_e2189 >> bitcast<u32>(12u)))) * _e1942)) + ((f32((bitcast<i32>((_e2189 & 4095u)) - 2048i)) * _e1923) * (_e2165 - f32(_e2180))));
let _e2205 = (_e2044 - _e2004);
let _e2207 = (_e2124 - _e2084);
let _e2209 = (_e2204 - _e2164);
phi_3600_ = type_29(_e1948, vec3<f32>((0.5f * _e2205), (0.5f * _e2207), (0.5f * _e2209)), vec3<f32>((0.25f * (_e2205 * (_e2044 + _e2004))), (0.25f * (_e2207 * (_e2124 + _e2084))), (0.25f * (_e2209 * (_e2204 + _e2164)))));
}
let _e2224 = phi_3600_;
let _e2239 = select(0f, 1f, ((((((_e699 >= -0.5f) && (_e699 <= _e722)) && (_e705 >= -0.5f)) && (_e705 <= _e732)) && (_e711 >= -0.5f)) && (_e711 <= _e742)));
let _e2241 = (0.5f * (_e1854 - _e1848));
let _e2243 = (0.5f * (_e1866 - _e1860));
let _e2245 = (0.5f * (_e1878 - _e1872));
let _e2251 = global_1.member.member_6.member.member.member;
let _e2257 = global_1.member.member_6.member.member.member_1;
let _e2263 = global_1.member.member_6.member.member.member_2;
let _e2269 = global_1.member.member_6.member_1.member.member;
let _e2275 = global_1.member.member_6.member_1.member.member_1;
let _e2281 = global_1.member.member_6.member_1.member.member_2;
let _e2287 = global_1.member.member_6.member_2.member.member;
let _e2293 = global_1.member.member_6.member_2.member.member_1;
let _e2299 = global_1.member.member_6.member_2.member.member_2;
phi_4378_ = type_30(_e1842, vec3<f32>(((((_e2251 * _e2241) + (_e2269 * _e2243)) + (_e2287 * _e2245)) * _e2239), ((((_e2257 * _e2241) + (_e2275 * _e2243)) + (_e2293 * _e2245)) * _e2239), ((((_e2263 * _e2241) + (_e2281 * _e2243)) + (_e2299 * _e2245)) * _e2239)), _e2224.member, vec3<f32>(((((_e2251 * _e2224.member_2.x) + (_e2269 * _e2224.member_2.y)) + (_e2287 * _e2224.member_2.z)) * _e2239), ((((_e2257 * _e2224.member_2.x) + (_e2275 * _e2224.member_2.y)) + (_e2293 * _e2224.member_2.z)) * _e2239), ((((_e2263 * _e2224.member_2.x) + (_e2281 * _e2224.member_2.y)) + (_e2299 * _e2224.member_2.z)) * _e2239)), vec3<f32>(((((_e2251 * _e2224.member_1.x) + (_e2269 * _e2224.member_1.y)) + (_e2287 * _e2224.member_1.z)) * _e2239), ((((_e2257 * _e2224.member_1.x) + (_e2275 * _e2224.member_1.y)) + (_e2293 * _e2224.member_1.z)) * _e2239), ((((_e2263 * _e2224.member_1.x) + (_e2281 * _e2224.member_1.y)) + (_e2299 * _e2224.member_1.z)) * _e2239)));
} else {
let _e2368 = global_1.member.member_6.member_3.member;
let _e2369 = (_e2368 - 0.5f);
let _e2371 = select(-0.5f, _e699, (_e699 > -0.5f));
let _e2373 = select(_e2369, _e2371, (_e2371 < _e2369));
let _e2378 = global_1.member.member_6.member_3.member_1;
let _e2379 = (_e2378 - 0.5f);
let _e2381 = select(-0.5f, _e705, (_e705 > -0.5f));
let _e2383 = select(_e2379, _e2381, (_e2381 < _e2379));
let _e2388 = global_1.member.member_6.member_3.member_2;
let _e2389 = (_e2388 - 0.5f);
let _e2391 = select(-0.5f, _e711, (_e711 > -0.5f));
let _e2393 = select(_e2389, _e2391, (_e2391 < _e2389));
let _e2395 = select(-1f, _e2373, (_e2373 > -1f));
let _e2397 = select(_e2368, _e2395, (_e2395 < _e2368));
let _e2404 = select(0i, select(select(i32(_e2397), i32(-2147483648), (_e2397 < -2147483600f)), 2147483647i, (_e2397 > 2147483500f)), (_e2397 == _e2397));
let _e2408 = (_e2404 - select(0i, 1i, (_e2397 < f32(_e2404))));
let _e2410 = select(-1f, _e2383, (_e2383 > -1f));
let _e2412 = select(_e2378, _e2410, (_e2410 < _e2378));
let _e2419 = select(0i, select(select(i32(_e2412), i32(-2147483648), (_e2412 < -2147483600f)), 2147483647i, (_e2412 > 2147483500f)), (_e2412 == _e2412));
let _e2423 = (_e2419 - select(0i, 1i, (_e2412 < f32(_e2419))));
let _e2425 = select(-1f, _e2393, (_e2393 > -1f));
let _e2427 = select(_e2388, _e2425, (_e2425 < _e2388));
let _e2434 = select(0i, select(select(i32(_e2427), i32(-2147483648), (_e2427 < -2147483600f)), 2147483647i, (_e2427 > 2147483500f)), (_e2427 == _e2427));
let _e2438 = (_e2434 - select(0i, 1i, (_e2427 < f32(_e2434))));
let _e2442 = global_1.member.member_6.member_7;
let _e2446 = global_1.member.member_6.member_8;
let _e2454 = (select(0i, select(select(i32(_e2378), i32(-2147483648), (_e2378 < -2147483600f)), 2147483647i, (_e2378 > 2147483500f)), (_e2378 == _e2378)) - 1i);
let _e2457 = (_e2423 + 1i);
let _e2467 = (select(0i, select(select(i32(_e2388), i32(-2147483648), (_e2388 < -2147483600f)), 2147483647i, (_e2388 > 2147483500f)), (_e2388 == _e2388)) - 1i);
let _e2470 = (_e2438 + 1i);
let _e2479 = select(0i, select(select(i32(_e2368), i32(-2147483648), (_e2368 < -2147483600f)), 2147483647i, (_e2368 > 2147483500f)), (_e2368 == _e2368));
let _e2480 = (_e2479 - 1i);
let _e2481 = (_e2408 - 1i);
let _e2483 = select(0i, _e2481, (_e2481 > 0i));
let _e2485 = select(0i, _e2408, (_e2408 > 0i));
let _e2486 = (_e2408 + 1i);
let _e2488 = select(_e2480, _e2486, (_e2486 < _e2480));
let _e2489 = (_e2408 + 2i);
let _e2492 = (_e2479 - 2i);
let _e2494 = select(0i, _e2492, (_e2492 > 0i));
let _e2496 = select(_e2494, _e2483, (_e2483 < _e2494));
let _e2498 = select(_e2494, _e2485, (_e2485 < _e2494));
let _e2500 = select(_e2494, _e2488, (_e2488 < _e2494));
let _e2519 = (select(0i, _e2423, (_e2423 > 0i)) * _e2442);
let _e2520 = (select(_e2454, _e2457, (_e2457 < _e2454)) * _e2442);
let _e2521 = (select(0i, _e2438, (_e2438 > 0i)) * _e2446);
let _e2522 = (select(_e2467, _e2470, (_e2470 < _e2467)) * _e2446);
local_2 = type_28(array<i32, 4>(_e2496, _e2498, _e2500, 0i), array<u32, 6>(bitcast<u32>(((_e2483 - _e2496) * 16i)), bitcast<u32>(((_e2485 - _e2496) * 16i)), bitcast<u32>(((_e2485 - _e2498) * 16i)), bitcast<u32>(((_e2488 - _e2498) * 16i)), bitcast<u32>(((_e2488 - _e2500) * 16i)), bitcast<u32>(((select(_e2480, _e2489, (_e2489 < _e2480)) - _e2500) * 16i))));
local_3 = vec3<f32>((_e2373 - f32(_e2408)), (_e2383 - f32(_e2423)), (_e2393 - f32(_e2438)));
let _e2537 = local_2.member[1u];
let _e2538 = ((_e2521 + _e2519) + _e2537);
let _e2540 = (_e2538 >> bitcast<u32>(1i));
let _e2543 = bitcast<u32>(((_e2538 & 1i) * 16i));
let _e2545 = (bitcast<i32>(_e86) - 1i);
let _e2547 = select(_e2545, _e2540, (_e2540 < _e2545));
let _e2552 = global_2.member[bitcast<u32>(select(0i, _e2547, (_e2547 > 0i)))];
let _e2556 = (_e2540 + 1i);
let _e2558 = select(_e2545, _e2556, (_e2556 < _e2545));
let _e2563 = global_2.member[bitcast<u32>(select(0i, _e2558, (_e2558 > 0i)))];
let _e2570 = ((_e2552 >> bitcast<u32>((_e2543 & 31u))) | ((_e2563 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2543) & 31u))));
let _e2573 = local_2.member_1[2u];
let _e2579 = f32(bitcast<i32>(((_e2570 >> bitcast<u32>((_e2573 & 31u))) & 65535u)));
let _e2582 = local_2.member_1[3u];
let _e2589 = local_3[0u];
let _e2592 = (_e2579 + ((f32(bitcast<i32>(((_e2570 >> bitcast<u32>((_e2582 & 31u))) & 65535u))) - _e2579) * _e2589));
let _e2594 = local_2.member[1u];
let _e2595 = ((_e2521 + _e2520) + _e2594);
let _e2597 = (_e2595 >> bitcast<u32>(1i));
let _e2600 = bitcast<u32>(((_e2595 & 1i) * 16i));
let _e2602 = select(_e2545, _e2597, (_e2597 < _e2545));
let _e2607 = global_2.member[bitcast<u32>(select(0i, _e2602, (_e2602 > 0i)))];
let _e2611 = (_e2597 + 1i);
let _e2613 = select(_e2545, _e2611, (_e2611 < _e2545));
let _e2618 = global_2.member[bitcast<u32>(select(0i, _e2613, (_e2613 > 0i)))];
let _e2625 = ((_e2607 >> bitcast<u32>((_e2600 & 31u))) | ((_e2618 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2600) & 31u))));
let _e2626 = local_2.member_1[2u];
let _e2632 = f32(bitcast<i32>(((_e2625 >> bitcast<u32>((_e2626 & 31u))) & 65535u)));
let _e2633 = local_2.member_1[3u];
let _e2640 = local_3[0u];
let _e2645 = local_3[1u];
let _e2648 = (_e2592 + (((_e2632 + ((f32(bitcast<i32>(((_e2625 >> bitcast<u32>((_e2633 & 31u))) & 65535u))) - _e2632) * _e2640)) - _e2592) * _e2645));
let _e2650 = local_2.member[1u];
let _e2651 = ((_e2522 + _e2519) + _e2650);
let _e2653 = (_e2651 >> bitcast<u32>(1i));
let _e2656 = bitcast<u32>(((_e2651 & 1i) * 16i));
let _e2658 = select(_e2545, _e2653, (_e2653 < _e2545));
let _e2663 = global_2.member[bitcast<u32>(select(0i, _e2658, (_e2658 > 0i)))];
let _e2667 = (_e2653 + 1i);
let _e2669 = select(_e2545, _e2667, (_e2667 < _e2545));
let _e2674 = global_2.member[bitcast<u32>(select(0i, _e2669, (_e2669 > 0i)))];
let _e2681 = ((_e2663 >> bitcast<u32>((_e2656 & 31u))) | ((_e2674 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2656) & 31u))));
let _e2682 = local_2.member_1[2u];
let _e2688 = f32(bitcast<i32>(((_e2681 >> bitcast<u32>((_e2682 & 31u))) & 65535u)));
let _e2689 = local_2.member_1[3u];
let _e2696 = local_3[0u];
let _e2699 = (_e2688 + ((f32(bitcast<i32>(((_e2681 >> bitcast<u32>((_e2689 & 31u))) & 65535u))) - _e2688) * _e2696));
let _e2701 = local_2.member[1u];
let _e2702 = ((_e2522 + _e2520) + _e2701);
let _e2704 = (_e2702 >> bitcast<u32>(1i));
let _e2707 = bitcast<u32>(((_e2702 & 1i) * 16i));
let _e2709 = select(_e2545, _e2704, (_e2704 < _e2545));
let _e2714 = global_2.member[bitcast<u32>(select(0i, _e2709, (_e2709 > 0i)))];
let _e2718 = (_e2704 + 1i);
let _e2720 = select(_e2545, _e2718, (_e2718 < _e2545));
let _e2725 = global_2.member[bitcast<u32>(select(0i, _e2720, (_e2720 > 0i)))];
let _e2732 = ((_e2714 >> bitcast<u32>((_e2707 & 31u))) | ((_e2725 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2707) & 31u))));
let _e2733 = local_2.member_1[2u];
let _e2739 = f32(bitcast<i32>(((_e2732 >> bitcast<u32>((_e2733 & 31u))) & 65535u)));
let _e2740 = local_2.member_1[3u];
let _e2747 = local_3[0u];
let _e2751 = local_3[1u];
let _e2756 = local_3[2u];
let _e2763 = global_1.member.member_6.member_5;
let _e2768 = global_1.member.member_6.member_6;
let _e2769 = (((_e2648 + (((_e2699 + (((_e2739 + ((f32(bitcast<i32>(((_e2732 >> bitcast<u32>((_e2740 & 31u))) & 65535u))) - _e2739) * _e2747)) - _e2699) * _e2751)) - _e2648) * _e2756)) * _e2763) + _e2768);
let _e2771 = select(0f, _e2769, (_e2769 > 0f));
phi_4378_ = type_30(select(1f, _e2771, (_e2771 < 1f)), vec3<f32>(0f, 0f, 0f), 1f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
}
let _e2776 = phi_4378_;
let _e2781 = global_1.member.member_6.member_3.member;
let _e2782 = (_e2781 - 0.5f);
let _e2784 = select(-0.5f, _e663, (_e663 > -0.5f));
let _e2786 = select(_e2782, _e2784, (_e2784 < _e2782));
let _e2791 = global_1.member.member_6.member_3.member_1;
let _e2792 = (_e2791 - 0.5f);
let _e2794 = select(-0.5f, _e678, (_e678 > -0.5f));
let _e2796 = select(_e2792, _e2794, (_e2794 < _e2792));
let _e2801 = global_1.member.member_6.member_3.member_2;
let _e2802 = (_e2801 - 0.5f);
let _e2804 = select(-0.5f, _e693, (_e693 > -0.5f));
let _e2806 = select(_e2802, _e2804, (_e2804 < _e2802));
let _e2808 = select(-1f, _e2786, (_e2786 > -1f));
let _e2810 = select(_e2781, _e2808, (_e2808 < _e2781));
let _e2817 = select(0i, select(select(i32(_e2810), i32(-2147483648), (_e2810 < -2147483600f)), 2147483647i, (_e2810 > 2147483500f)), (_e2810 == _e2810));
let _e2821 = (_e2817 - select(0i, 1i, (_e2810 < f32(_e2817))));
let _e2823 = select(-1f, _e2796, (_e2796 > -1f));
let _e2825 = select(_e2791, _e2823, (_e2823 < _e2791));
let _e2832 = select(0i, select(select(i32(_e2825), i32(-2147483648), (_e2825 < -2147483600f)), 2147483647i, (_e2825 > 2147483500f)), (_e2825 == _e2825));
let _e2836 = (_e2832 - select(0i, 1i, (_e2825 < f32(_e2832))));
let _e2838 = select(-1f, _e2806, (_e2806 > -1f));
let _e2840 = select(_e2801, _e2838, (_e2838 < _e2801));
let _e2847 = select(0i, select(select(i32(_e2840), i32(-2147483648), (_e2840 < -2147483600f)), 2147483647i, (_e2840 > 2147483500f)), (_e2840 == _e2840));
let _e2851 = (_e2847 - select(0i, 1i, (_e2840 < f32(_e2847))));
let _e2855 = global_1.member.member_6.member_7;
let _e2859 = global_1.member.member_6.member_8;
let _e2867 = (select(0i, select(select(i32(_e2791), i32(-2147483648), (_e2791 < -2147483600f)), 2147483647i, (_e2791 > 2147483500f)), (_e2791 == _e2791)) - 1i);
let _e2870 = (_e2836 + 1i);
let _e2880 = (select(0i, select(select(i32(_e2801), i32(-2147483648), (_e2801 < -2147483600f)), 2147483647i, (_e2801 > 2147483500f)), (_e2801 == _e2801)) - 1i);
let _e2883 = (_e2851 + 1i);
let _e2892 = select(0i, select(select(i32(_e2781), i32(-2147483648), (_e2781 < -2147483600f)), 2147483647i, (_e2781 > 2147483500f)), (_e2781 == _e2781));
let _e2893 = (_e2892 - 1i);
let _e2894 = (_e2821 - 1i);
let _e2896 = select(0i, _e2894, (_e2894 > 0i));
let _e2898 = select(0i, _e2821, (_e2821 > 0i));
let _e2899 = (_e2821 + 1i);
let _e2901 = select(_e2893, _e2899, (_e2899 < _e2893));
let _e2902 = (_e2821 + 2i);
let _e2905 = (_e2892 - 2i);
let _e2907 = select(0i, _e2905, (_e2905 > 0i));
let _e2909 = select(_e2907, _e2896, (_e2896 < _e2907));
let _e2911 = select(_e2907, _e2898, (_e2898 < _e2907));
let _e2913 = select(_e2907, _e2901, (_e2901 < _e2907));
let _e2932 = (select(0i, _e2836, (_e2836 > 0i)) * _e2855);
let _e2933 = (select(_e2867, _e2870, (_e2870 < _e2867)) * _e2855);
let _e2934 = (select(0i, _e2851, (_e2851 > 0i)) * _e2859);
let _e2935 = (select(_e2880, _e2883, (_e2883 < _e2880)) * _e2859);
local = type_28(array<i32, 4>(_e2909, _e2911, _e2913, 0i), array<u32, 6>(bitcast<u32>(((_e2896 - _e2909) * 16i)), bitcast<u32>(((_e2898 - _e2909) * 16i)), bitcast<u32>(((_e2898 - _e2911) * 16i)), bitcast<u32>(((_e2901 - _e2911) * 16i)), bitcast<u32>(((_e2901 - _e2913) * 16i)), bitcast<u32>(((select(_e2893, _e2902, (_e2902 < _e2893)) - _e2913) * 16i))));
local_1 = vec3<f32>((_e2786 - f32(_e2821)), (_e2796 - f32(_e2836)), (_e2806 - f32(_e2851)));
let _e2950 = local.member[1u];
let _e2951 = ((_e2934 + _e2932) + _e2950);
let _e2953 = (_e2951 >> bitcast<u32>(1i));
let _e2956 = bitcast<u32>(((_e2951 & 1i) * 16i));
let _e2958 = (bitcast<i32>(_e86) - 1i);
let _e2960 = select(_e2958, _e2953, (_e2953 < _e2958));
let _e2965 = global_2.member[bitcast<u32>(select(0i, _e2960, (_e2960 > 0i)))];
let _e2969 = (_e2953 + 1i);
let _e2971 = select(_e2958, _e2969, (_e2969 < _e2958));
let _e2976 = global_2.member[bitcast<u32>(select(0i, _e2971, (_e2971 > 0i)))];
let _e2983 = ((_e2965 >> bitcast<u32>((_e2956 & 31u))) | ((_e2976 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2956) & 31u))));
let _e2986 = local.member_1[2u];
let _e2992 = f32(bitcast<i32>(((_e2983 >> bitcast<u32>((_e2986 & 31u))) & 65535u)));
let _e2995 = local.member_1[3u];
let _e3002 = local_1[0u];
let _e3005 = (_e2992 + ((f32(bitcast<i32>(((_e2983 >> bitcast<u32>((_e2995 & 31u))) & 65535u))) - _e2992) * _e3002));
let _e3007 = local.member[1u];
let _e3008 = ((_e2934 + _e2933) + _e3007);
let _e3010 = (_e3008 >> bitcast<u32>(1i));
let _e3013 = bitcast<u32>(((_e3008 & 1i) * 16i));
let _e3015 = select(_e2958, _e3010, (_e3010 < _e2958));
let _e3020 = global_2.member[bitcast<u32>(select(0i, _e3015, (_e3015 > 0i)))];
let _e3024 = (_e3010 + 1i);
let _e3026 = select(_e2958, _e3024, (_e3024 < _e2958));
let _e3031 = global_2.member[bitcast<u32>(select(0i, _e3026, (_e3026 > 0i)))];
let _e3038 = ((_e3020 >> bitcast<u32>((_e3013 & 31u))) | ((_e3031 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3013) & 31u))));
let _e3039 = local.member_1[2u];
let _e3045 = f32(bitcast<i32>(((_e3038 >> bitcast<u32>((_e3039 & 31u))) & 65535u)));
let _e3046 = local.member_1[3u];
let _e3053 = local_1[0u];
let _e3058 = local_1[1u];
let _e3061 = (_e3005 + (((_e3045 + ((f32(bitcast<i32>(((_e3038 >> bitcast<u32>((_e3046 & 31u))) & 65535u))) - _e3045) * _e3053)) - _e3005) * _e3058));
let _e3063 = local.member[1u];
let _e3064 = ((_e2935 + _e2932) + _e3063);
let _e3066 = (_e3064 >> bitcast<u32>(1i));
let _e3069 = bitcast<u32>(((_e3064 & 1i) * 16i));
let _e3071 = select(_e2958, _e3066, (_e3066 < _e2958));
let _e3076 = global_2.member[bitcast<u32>(select(0i, _e3071, (_e3071 > 0i)))];
let _e3080 = (_e3066 + 1i);
let _e3082 = select(_e2958, _e3080, (_e3080 < _e2958));
let _e3087 = global_2.member[bitcast<u32>(select(0i, _e3082, (_e3082 > 0i)))];
let _e3094 = ((_e3076 >> bitcast<u32>((_e3069 & 31u))) | ((_e3087 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3069) & 31u))));
let _e3095 = local.member_1[2u];
let _e3101 = f32(bitcast<i32>(((_e3094 >> bitcast<u32>((_e3095 & 31u))) & 65535u)));
let _e3102 = local.member_1[3u];
let _e3109 = local_1[0u];
let _e3112 = (_e3101 + ((f32(bitcast<i32>(((_e3094 >> bitcast<u32>((_e3102 & 31u))) & 65535u))) - _e3101) * _e3109));
let _e3114 = local.member[1u];
let _e3115 = ((_e2935 + _e2933) + _e3114);
let _e3117 = (_e3115 >> bitcast<u32>(1i));
let _e3120 = bitcast<u32>(((_e3115 & 1i) * 16i));
let _e3122 = select(_e2958, _e3117, (_e3117 < _e2958));
let _e3127 = global_2.member[bitcast<u32>(select(0i, _e3122, (_e3122 > 0i)))];
let _e3131 = (_e3117 + 1i);
let _e3133 = select(_e2958, _e3131, (_e3131 < _e2958));
let _e3138 = global_2.member[bitcast<u32>(select(0i, _e3133, (_e3133 > 0i)))];
let _e3145 = ((_e3127 >> bitcast<u32>((_e3120 & 31u))) | ((_e3138 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3120) & 31u))));
let _e3146 = local.member_1[2u];
let _e3152 = f32(bitcast<i32>(((_e3145 >> bitcast<u32>((_e3146 & 31u))) & 65535u)));
let _e3153 = local.member_1[3u];
let _e3160 = local_1[0u];
let _e3164 = local_1[1u];
let _e3169 = local_1[2u];
let _e3176 = global_1.member.member_6.member_5;
let _e3181 = global_1.member.member_6.member_6;
let _e3182 = (((_e3061 + (((_e3112 + (((_e3152 + ((f32(bitcast<i32>(((_e3145 >> bitcast<u32>((_e3153 & 31u))) & 65535u))) - _e3152) * _e3160)) - _e3112) * _e3164)) - _e3061) * _e3169)) * _e3176) + _e3181);
let _e3184 = select(0f, _e3182, (_e3182 > 0f));
let _e3186 = select(1f, _e3184, (_e3184 < 1f));
let _e3189 = global_1.member.member_1;
if ((_e3189 & 16u) == 0u) {
phi_5343_ = type_5(1f, 1f, 1f);
} else {
let _e3195 = global_1.member.member_14.member;
let _e3206 = ((((_e3195.member.member * _e620) + (_e3195.member.member_1 * _e633)) + (_e3195.member.member_2 * _e598)) + _e3195.member_1);
let _e3212 = ((((_e3195.member.member * _e643) + (_e3195.member.member_1 * _e648)) + (_e3195.member.member_2 * _e637)) + _e3195.member_1);
let _e3214 = select(_e3212, _e3206, (_e3206 < _e3212));
let _e3216 = select(_e3212, _e3206, (_e3206 > _e3212));
let _e3218 = (_e3216 - _e3214);
let _e3221 = (-(_e3214) / select(1e-30f, _e3218, (_e3218 > 1e-30f)));
let _e3223 = select(0f, _e3221, (_e3221 > 0f));
let _e3229 = select(select(select(1f, _e3223, (_e3223 < 1f)), 1f, (_e3216 <= 0f)), 0f, (_e3214 > 0f));
let _e3234 = global_1.member.member_14.member_1;
let _e3235 = (_e3234 != 0u);
let _e3245 = global_1.member.member_15.member;
let _e3256 = ((((_e3245.member.member * _e620) + (_e3245.member.member_1 * _e633)) + (_e3245.member.member_2 * _e598)) + _e3245.member_1);
let _e3262 = ((((_e3245.member.member * _e643) + (_e3245.member.member_1 * _e648)) + (_e3245.member.member_2 * _e637)) + _e3245.member_1);
let _e3264 = select(_e3262, _e3256, (_e3256 < _e3262));
let _e3266 = select(_e3262, _e3256, (_e3256 > _e3262));
let _e3268 = (_e3266 - _e3264);
let _e3271 = (-(_e3264) / select(1e-30f, _e3268, (_e3268 > 1e-30f)));
let _e3273 = select(0f, _e3271, (_e3271 > 0f));
let _e3279 = select(select(select(1f, _e3273, (_e3273 < 1f)), 1f, (_e3266 <= 0f)), 0f, (_e3264 > 0f));
let _e3284 = global_1.member.member_15.member_1;
let _e3285 = (_e3284 != 0u);
let _e3295 = global_1.member.member_16.member;
let _e3306 = ((((_e3295.member.member * _e620) + (_e3295.member.member_1 * _e633)) + (_e3295.member.member_2 * _e598)) + _e3295.member_1);
let _e3312 = ((((_e3295.member.member * _e643) + (_e3295.member.member_1 * _e648)) + (_e3295.member.member_2 * _e637)) + _e3295.member_1);
let _e3314 = select(_e3312, _e3306, (_e3306 < _e3312));
let _e3316 = select(_e3312, _e3306, (_e3306 > _e3312));
let _e3318 = (_e3316 - _e3314);
let _e3321 = (-(_e3314) / select(1e-30f, _e3318, (_e3318 > 1e-30f)));
let _e3323 = select(0f, _e3321, (_e3321 > 0f));
let _e3329 = select(select(select(1f, _e3323, (_e3323 < 1f)), 1f, (_e3316 <= 0f)), 0f, (_e3314 > 0f));
let _e3334 = global_1.member.member_16.member_1;
let _e3335 = (_e3334 != 0u);
let _e3345 = global_1.member.member_17.member;
let _e3356 = ((((_e3345.member.member * _e620) + (_e3345.member.member_1 * _e633)) + (_e3345.member.member_2 * _e598)) + _e3345.member_1);
let _e3362 = ((((_e3345.member.member * _e643) + (_e3345.member.member_1 * _e648)) + (_e3345.member.member_2 * _e637)) + _e3345.member_1);
let _e3364 = select(_e3362, _e3356, (_e3356 < _e3362));
let _e3366 = select(_e3362, _e3356, (_e3356 > _e3362));
let _e3368 = (_e3366 - _e3364);
let _e3371 = (-(_e3364) / select(1e-30f, _e3368, (_e3368 > 1e-30f)));
let _e3373 = select(0f, _e3371, (_e3371 > 0f));
let _e3379 = select(select(select(1f, _e3373, (_e3373 < 1f)), 1f, (_e3366 <= 0f)), 0f, (_e3364 > 0f));
let _e3384 = global_1.member.member_17.member_1;
let _e3385 = (_e3384 != 0u);
phi_5343_ = type_5(((((1f * _e3229) * _e3279) * _e3329) * _e3379), ((((1f * select(1f, _e3229, _e3235)) * select(1f, _e3279, _e3285)) * select(1f, _e3329, _e3335)) * select(1f, _e3379, _e3385)), ((((1f * select(1f, 0f, (_e3235 && (_e3212 > 0f)))) * select(1f, 0f, (_e3285 && (_e3262 > 0f)))) * select(1f, 0f, (_e3335 && (_e3312 > 0f)))) * select(1f, 0f, (_e3385 && (_e3362 > 0f)))));
}
let _e3394 = phi_5343_;
let _e3395 = (_e699 - _e663);
let _e3399 = (bitcast<f32>((bitcast<u32>(_e3395) & 2147483647u)) < 1e-12f);
let _e3401 = (1f / select(_e3395, 1f, _e3399));
let _e3403 = ((-0.5f - _e663) * _e3401);
let _e3405 = ((_e2782 - _e663) * _e3401);
let _e3411 = select(_e3405, _e3403, (_e3403 < _e3405));
let _e3413 = select(0f, _e3411, (_e3411 > 0f));
let _e3416 = select(select(1f, _e3413, (_e3413 < 1f)), select(2f, 0f, ((_e663 >= -0.5f) && (_e663 <= _e2782))), _e3399);
let _e3418 = select(_e3405, _e3403, (_e3403 > _e3405));
let _e3420 = select(0f, _e3418, (_e3418 > 0f));
let _e3423 = select(select(1f, _e3420, (_e3420 < 1f)), 1f, _e3399);
let _e3424 = (_e705 - _e678);
let _e3428 = (bitcast<f32>((bitcast<u32>(_e3424) & 2147483647u)) < 1e-12f);
let _e3430 = (1f / select(_e3424, 1f, _e3428));
let _e3432 = ((-0.5f - _e678) * _e3430);
let _e3434 = ((_e2792 - _e678) * _e3430);
let _e3440 = select(_e3434, _e3432, (_e3432 < _e3434));
let _e3442 = select(0f, _e3440, (_e3440 > 0f));
let _e3445 = select(select(1f, _e3442, (_e3442 < 1f)), select(2f, 0f, ((_e678 >= -0.5f) && (_e678 <= _e2792))), _e3428);
let _e3447 = select(_e3434, _e3432, (_e3432 > _e3434));
let _e3449 = select(0f, _e3447, (_e3447 > 0f));
let _e3452 = select(select(1f, _e3449, (_e3449 < 1f)), 1f, _e3428);
let _e3453 = (_e711 - _e693);
let _e3457 = (bitcast<f32>((bitcast<u32>(_e3453) & 2147483647u)) < 1e-12f);
let _e3459 = (1f / select(_e3453, 1f, _e3457));
let _e3461 = ((-0.5f - _e693) * _e3459);
let _e3463 = ((_e2802 - _e693) * _e3459);
let _e3469 = select(_e3463, _e3461, (_e3461 < _e3463));
let _e3471 = select(0f, _e3469, (_e3469 > 0f));
let _e3474 = select(select(1f, _e3471, (_e3471 < 1f)), select(2f, 0f, ((_e693 >= -0.5f) && (_e693 <= _e2802))), _e3457);
let _e3476 = select(_e3463, _e3461, (_e3461 > _e3463));
let _e3478 = select(0f, _e3476, (_e3476 > 0f));
let _e3481 = select(select(1f, _e3478, (_e3478 < 1f)), 1f, _e3457);
let _e3483 = select(_e3452, _e3423, (_e3423 < _e3452));
let _e3487 = select(_e3445, _e3416, (_e3416 > _e3445));
let _e3490 = (select(_e3481, _e3483, (_e3483 < _e3481)) - select(_e3474, _e3487, (_e3487 > _e3474)));
let _e3493 = (_e643 - _e620);
let _e3494 = (_e648 - _e633);
let _e3495 = (_e637 - _e598);
let _e3500 = (((_e3493 * _e3493) + (_e3494 * _e3494)) + (_e3495 * _e3495));
let _e3508 = global_1.member.member_5.member_3;
let _e3509 = ((sqrt(select(0f, _e3500, (_e3500 > 0f))) * select(0f, _e3490, (_e3490 > 0f))) * _e3508);
if (_e100.member_2 >= 3u) {
let _e3512 = (_e3186 * 255f);
let _e3513 = (_e2776.member * 255f);
let _e3514 = (255f - 1f);
let _e3516 = select(0f, _e3512, (_e3512 > 0f));
let _e3518 = select(_e3514, _e3516, (_e3516 < _e3514));
let _e3525 = select(0i, select(select(i32(_e3518), i32(-2147483648), (_e3518 < -2147483600f)), 2147483647i, (_e3518 > 2147483500f)), (_e3518 == _e3518));
let _e3529 = (_e3525 - select(0i, 1i, (_e3518 < f32(_e3525))));
let _e3531 = select(0f, _e3513, (_e3513 > 0f));
let _e3533 = select(_e3514, _e3531, (_e3531 < _e3514));
let _e3540 = select(0i, select(select(i32(_e3533), i32(-2147483648), (_e3533 < -2147483600f)), 2147483647i, (_e3533 > 2147483500f)), (_e3533 == _e3533));
let _e3544 = (_e3540 - select(0i, 1i, (_e3533 < f32(_e3540))));
let _e3547 = (((_e3529 * 256i) + _e3544) * 4i);
let _e3551 = (_e3513 - f32(_e3544));
let _e3553 = (bitcast<i32>(_e90) - 1i);
let _e3555 = select(_e3553, _e3547, (_e3547 < _e3553));
let _e3561 = global_4.member[bitcast<u32>(select(0i, _e3555, (_e3555 > 0i)))];
let _e3562 = (_e3547 + 4i);
let _e3564 = select(_e3553, _e3562, (_e3562 < _e3553));
let _e3570 = global_4.member[bitcast<u32>(select(0i, _e3564, (_e3564 > 0i)))];
let _e3571 = (_e3547 + 1024i);
let _e3573 = select(_e3553, _e3571, (_e3571 < _e3553));
let _e3579 = global_4.member[bitcast<u32>(select(0i, _e3573, (_e3573 > 0i)))];
let _e3580 = (_e3547 + 1028i);
let _e3582 = select(_e3553, _e3580, (_e3580 < _e3553));
let _e3588 = global_4.member[bitcast<u32>(select(0i, _e3582, (_e3582 > 0i)))];
let _e3593 = (bitcast<f32>(((_e3561 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3601 = (_e3593 + (((bitcast<f32>(((_e3570 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3593) * _e3551));
let _e3606 = (bitcast<f32>(((_e3579 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3617 = (_e3601 + (((_e3606 + (((bitcast<f32>(((_e3588 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3606) * _e3551)) - _e3601) * (_e3512 - f32(_e3529))));
let _e3621 = -((_e3617 * (_e3509 * _e3394.member)));
let _e3623 = select(-87f, _e3621, (_e3621 > -87f));
let _e3625 = select(88f, _e3623, (_e3623 < 88f));
let _e3627 = ((_e3625 * 1.442695f) + 0.5f);
let _e3629 = select(-127f, _e3627, (_e3627 > -127f));
let _e3631 = select(128f, _e3629, (_e3629 < 128f));
let _e3638 = select(0i, select(select(i32(_e3631), i32(-2147483648), (_e3631 < -2147483600f)), 2147483647i, (_e3631 > 2147483500f)), (_e3631 == _e3631));
let _e3642 = (_e3638 - select(0i, 1i, (_e3631 < f32(_e3638))));
let _e3643 = f32(_e3642);
let _e3647 = ((_e3625 - (_e3643 * 0.6933594f)) - (_e3643 * -2.1219444e-4f));
let _e3667 = ((1f + (_e3647 * (1f + (_e3647 * (0.5f + (_e3647 * (0.16666667f + (_e3647 * (0.041666668f + (_e3647 * (0.008333334f + (_e3647 * (0.001388889f + (_e3647 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3642 + 127i)) << bitcast<u32>(23i))));
let _e3668 = (1f - _e3667);
phi_6453_ = type_31(_e3667, _e3668, vec3<f32>(1f, 1f, 1f), vec3((0f * (_e3668 / select(1e-12f, _e3617, (_e3617 > 1e-12f))))));
} else {
let _e3676 = (_e3186 * 255f);
let _e3677 = (_e2776.member * 255f);
let _e3678 = (255f - 1f);
let _e3680 = select(0f, _e3676, (_e3676 > 0f));
let _e3682 = select(_e3678, _e3680, (_e3680 < _e3678));
let _e3689 = select(0i, select(select(i32(_e3682), i32(-2147483648), (_e3682 < -2147483600f)), 2147483647i, (_e3682 > 2147483500f)), (_e3682 == _e3682));
let _e3693 = (_e3689 - select(0i, 1i, (_e3682 < f32(_e3689))));
let _e3695 = select(0f, _e3677, (_e3677 > 0f));
let _e3697 = select(_e3678, _e3695, (_e3695 < _e3678));
let _e3704 = select(0i, select(select(i32(_e3697), i32(-2147483648), (_e3697 < -2147483600f)), 2147483647i, (_e3697 > 2147483500f)), (_e3697 == _e3697));
let _e3708 = (_e3704 - select(0i, 1i, (_e3697 < f32(_e3704))));
let _e3711 = (((_e3693 * 256i) + _e3708) * 4i);
let _e3713 = (_e3676 - f32(_e3693));
let _e3715 = (_e3677 - f32(_e3708));
let _e3717 = (bitcast<i32>(_e90) - 1i);
let _e3719 = select(_e3717, _e3711, (_e3711 < _e3717));
let _e3725 = global_4.member[bitcast<u32>(select(0i, _e3719, (_e3719 > 0i)))];
let _e3726 = (_e3711 + 4i);
let _e3728 = select(_e3717, _e3726, (_e3726 < _e3717));
let _e3734 = global_4.member[bitcast<u32>(select(0i, _e3728, (_e3728 > 0i)))];
let _e3735 = (_e3711 + 1024i);
let _e3737 = select(_e3717, _e3735, (_e3735 < _e3717));
let _e3743 = global_4.member[bitcast<u32>(select(0i, _e3737, (_e3737 > 0i)))];
let _e3744 = (_e3711 + 1028i);
let _e3746 = select(_e3717, _e3744, (_e3744 < _e3717));
let _e3752 = global_4.member[bitcast<u32>(select(0i, _e3746, (_e3746 > 0i)))];
let _e3757 = (bitcast<f32>(((_e3725 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3765 = (_e3757 + (((bitcast<f32>(((_e3734 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3757) * _e3715));
let _e3770 = (bitcast<f32>(((_e3743 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3781 = (_e3765 + (((_e3770 + (((bitcast<f32>(((_e3752 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3770) * _e3715)) - _e3765) * _e3713));
let _e3794 = (bitcast<f32>((((_e3725 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3802 = (_e3794 + (((bitcast<f32>((((_e3734 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3794) * _e3715));
let _e3807 = (bitcast<f32>((((_e3743 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3819 = (_e3711 + 1i);
let _e3821 = select(_e3717, _e3819, (_e3819 < _e3717));
let _e3827 = global_4.member[bitcast<u32>(select(0i, _e3821, (_e3821 > 0i)))];
let _e3828 = (_e3711 + 5i);
let _e3830 = select(_e3717, _e3828, (_e3828 < _e3717));
let _e3836 = global_4.member[bitcast<u32>(select(0i, _e3830, (_e3830 > 0i)))];
let _e3837 = (_e3711 + 1025i);
let _e3839 = select(_e3717, _e3837, (_e3837 < _e3717));
let _e3845 = global_4.member[bitcast<u32>(select(0i, _e3839, (_e3839 > 0i)))];
let _e3846 = (_e3711 + 1029i);
let _e3848 = select(_e3717, _e3846, (_e3846 < _e3717));
let _e3854 = global_4.member[bitcast<u32>(select(0i, _e3848, (_e3848 > 0i)))];
let _e3859 = (bitcast<f32>(((_e3827 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3867 = (_e3859 + (((bitcast<f32>(((_e3836 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3859) * _e3715));
let _e3872 = (bitcast<f32>(((_e3845 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3896 = (bitcast<f32>((((_e3827 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3904 = (_e3896 + (((bitcast<f32>((((_e3836 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3896) * _e3715));
let _e3909 = (bitcast<f32>((((_e3845 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3924 = (_e3509 * _e3394.member_1);
let _e3926 = -(((_e3802 + (((_e3807 + (((bitcast<f32>((((_e3752 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3807) * _e3715)) - _e3802) * _e3713)) * _e3924));
let _e3928 = select(-87f, _e3926, (_e3926 > -87f));
let _e3930 = select(88f, _e3928, (_e3928 < 88f));
let _e3932 = ((_e3930 * 1.442695f) + 0.5f);
let _e3934 = select(-127f, _e3932, (_e3932 > -127f));
let _e3936 = select(128f, _e3934, (_e3934 < 128f));
let _e3943 = select(0i, select(select(i32(_e3936), i32(-2147483648), (_e3936 < -2147483600f)), 2147483647i, (_e3936 > 2147483500f)), (_e3936 == _e3936));
let _e3947 = (_e3943 - select(0i, 1i, (_e3936 < f32(_e3943))));
let _e3948 = f32(_e3947);
let _e3952 = ((_e3930 - (_e3948 * 0.6933594f)) - (_e3948 * -2.1219444e-4f));
let _e3974 = -(((_e3867 + (((_e3872 + (((bitcast<f32>(((_e3854 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3872) * _e3715)) - _e3867) * _e3713)) * _e3924));
let _e3976 = select(-87f, _e3974, (_e3974 > -87f));
let _e3978 = select(88f, _e3976, (_e3976 < 88f));
let _e3980 = ((_e3978 * 1.442695f) + 0.5f);
let _e3982 = select(-127f, _e3980, (_e3980 > -127f));
let _e3984 = select(128f, _e3982, (_e3982 < 128f));
let _e3991 = select(0i, select(select(i32(_e3984), i32(-2147483648), (_e3984 < -2147483600f)), 2147483647i, (_e3984 > 2147483500f)), (_e3984 == _e3984));
let _e3995 = (_e3991 - select(0i, 1i, (_e3984 < f32(_e3991))));
let _e3996 = f32(_e3995);
let _e4000 = ((_e3978 - (_e3996 * 0.6933594f)) - (_e3996 * -2.1219444e-4f));
let _e4022 = -(((_e3904 + (((_e3909 + (((bitcast<f32>((((_e3854 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3909) * _e3715)) - _e3904) * _e3713)) * _e3924));
let _e4024 = select(-87f, _e4022, (_e4022 > -87f));
let _e4026 = select(88f, _e4024, (_e4024 < 88f));
let _e4028 = ((_e4026 * 1.442695f) + 0.5f);
let _e4030 = select(-127f, _e4028, (_e4028 > -127f));
let _e4032 = select(128f, _e4030, (_e4030 < 128f));
let _e4039 = select(0i, select(select(i32(_e4032), i32(-2147483648), (_e4032 < -2147483600f)), 2147483647i, (_e4032 > 2147483500f)), (_e4032 == _e4032));
let _e4043 = (_e4039 - select(0i, 1i, (_e4032 < f32(_e4039))));
let _e4044 = f32(_e4043);
let _e4048 = ((_e4026 - (_e4044 * 0.6933594f)) - (_e4044 * -2.1219444e-4f));
let _e4071 = -((_e3781 * (_e3509 * _e3394.member)));
let _e4073 = select(-87f, _e4071, (_e4071 > -87f));
let _e4075 = select(88f, _e4073, (_e4073 < 88f));
let _e4077 = ((_e4075 * 1.442695f) + 0.5f);
let _e4079 = select(-127f, _e4077, (_e4077 > -127f));
let _e4081 = select(128f, _e4079, (_e4079 < 128f));
let _e4088 = select(0i, select(select(i32(_e4081), i32(-2147483648), (_e4081 < -2147483600f)), 2147483647i, (_e4081 > 2147483500f)), (_e4081 == _e4081));
let _e4092 = (_e4088 - select(0i, 1i, (_e4081 < f32(_e4088))));
let _e4093 = f32(_e4092);
let _e4097 = ((_e4075 - (_e4093 * 0.6933594f)) - (_e4093 * -2.1219444e-4f));
let _e4117 = ((1f + (_e4097 * (1f + (_e4097 * (0.5f + (_e4097 * (0.16666667f + (_e4097 * (0.041666668f + (_e4097 * (0.008333334f + (_e4097 * (0.001388889f + (_e4097 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4092 + 127i)) << bitcast<u32>(23i))));
let _e4118 = (1f - _e4117);
phi_6453_ = type_31(_e4117, _e4118, vec3<f32>(((1f + (_e3952 * (1f + (_e3952 * (0.5f + (_e3952 * (0.16666667f + (_e3952 * (0.041666668f + (_e3952 * (0.008333334f + (_e3952 * (0.001388889f + (_e3952 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3947 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e4000 * (1f + (_e4000 * (0.5f + (_e4000 * (0.16666667f + (_e4000 * (0.041666668f + (_e4000 * (0.008333334f + (_e4000 * (0.001388889f + (_e4000 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3995 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e4048 * (1f + (_e4048 * (0.5f + (_e4048 * (0.16666667f + (_e4048 * (0.041666668f + (_e4048 * (0.008333334f + (_e4048 * (0.001388889f + (_e4048 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4043 + 127i)) << bitcast<u32>(23i))))), vec3((0f * (_e4118 / select(1e-12f, _e3781, (_e3781 > 1e-12f))))));
}
let _e4126 = phi_6453_;
if _e716 {
let _e4130 = global_1.member.member_5.member_2;
let _e4138 = global_1.member.member_5.member_4;
let _e4141 = (_e2776.member_3.x * _e3394.member_2);
let _e4143 = (_e2776.member_3.y * _e3394.member_2);
let _e4145 = (_e2776.member_3.z * _e3394.member_2);
let _e4146 = (0.5f * (_e4130 / select(1e-6f, _e180, (_e180 > 1e-6f))));
let _e4150 = (_e158 + (_e4141 * _e4146));
let _e4151 = (_e169 + (_e4143 * _e4146));
let _e4152 = (_e180 + (_e4145 * _e4146));
let _e4154 = (2f * _e4130);
let _e4156 = ((_e4152 * _e4152) + (_e4154 * _e4145));
let _e4160 = (_e4152 + sqrt(select(0f, _e4156, (_e4156 > 0f))));
let _e4164 = (0.5f * (_e4154 / select(1e-6f, _e4160, (_e4160 > 1e-6f))));
let _e4168 = (_e4150 + (_e4141 * _e4164));
let _e4169 = (_e4151 + (_e4143 * _e4164));
let _e4170 = (_e4152 + (_e4145 * _e4164));
let _e4174 = (_e4138 * _e4138);
let _e4176 = (_e4170 * _e4170);
let _e4184 = (((_e4152 <= 0f) || (_e4156 <= 0f)) || ((_e4170 <= 0f) || (_e4176 <= (_e4174 * (((_e4168 * _e4168) + (_e4169 * _e4169)) + _e4176)))));
let _e4198 = (_e158 + ((_e2776.member_4.x * _e3394.member_2) * _e4130));
let _e4199 = (_e169 + ((_e2776.member_4.y * _e3394.member_2) * _e4130));
let _e4200 = (_e180 + ((_e2776.member_4.z * _e3394.member_2) * _e4130));
let _e4202 = (_e4200 * _e4200);
let _e4211 = ((_e3189 & 1u) != 0u);
let _e4215 = select(_e4184, ((_e4200 <= 0f) || (_e4202 <= (_e4174 * (((_e4198 * _e4198) + (_e4199 * _e4199)) + _e4202)))), _e4211);
phi_6604_ = select(select(select(_e4170, _e4152, _e4184), _e4200, _e4211), _e180, _e4215);
phi_6605_ = select(select(select(_e4169, _e4151, _e4184), _e4199, _e4211), _e169, _e4215);
phi_6606_ = select(select(select(_e4168, _e4150, _e4184), _e4198, _e4211), _e158, _e4215);
phi_6607_ = select(1f, 0f, _e4215);
} else {
phi_6604_ = _e180;
phi_6605_ = _e169;
phi_6606_ = _e158;
phi_6607_ = 1f;
}
let _e4221 = phi_6604_;
let _e4223 = phi_6605_;
let _e4225 = phi_6606_;
let _e4227 = phi_6607_;
let _e4230 = (_e4126.member * _e4227);
global_5.member[_e115] = (_e126 * (_e4126.member_2.x * _e4230));
global_5.member[_e127] = (_e136 * (_e4126.member_2.y * _e4230));
global_5.member[_e138] = (_e147 * (_e4126.member_2.z * _e4230));
global_5.member[_e149] = _e4225;
global_5.member[_e160] = _e4223;
global_5.member[_e171] = _e4221;
global_5.member[_e182] = _e191;
global_5.member[_e193] = _e202;
global_5.member[_e204] = _e213;
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
